//! One row: every column whose nearest obstacle lies `g` rows away raises the parabola
//! `(x - column)^2 + g^2`; the row's distances are the lowest of them.

use super::DistanceCell;

/// A column that is nearest to some cells of a row: scratch memory of a distance map, 12 bytes.
#[derive(Clone, Copy, Debug)]
pub struct EnvelopeVertex {
    column: u32,
    /// Square of its distance to the obstacle in its column.
    height: u32,
    /// First cell of the row that it is nearest to.
    start: u32,
}

impl EnvelopeVertex {
    /// All bits zero; the contents do not matter.
    pub const EMPTY: Self = Self {
        column: 0,
        height: 0,
        start: 0,
    };

    /// Squared distance of a cell.
    #[inline(always)]
    fn at(&self, x: u32) -> u32 {
        let dx = x.abs_diff(self.column);
        dx * dx + self.height
    }
}

/// The vertices of a row, from left to right, in the first part of `vertices`; columns whose obstacle is farther
/// than `reach` raise none.
///
/// Rows and `reach` are at most [`MAX_SIDE`](super::MAX_SIDE): sums of two squares fit 31 bits.
#[inline(always)]
pub(super) fn build(
    vertices: &mut [EnvelopeVertex],
    distances: impl Iterator<Item = u32>,
    width: u32,
    reach: u32,
) -> Envelope<'_> {
    let mut used = 0_usize;
    for (column, distance) in (0..width).zip(distances) {
        if distance > reach {
            continue;
        }
        let height = distance * distance;
        let mut new = EnvelopeVertex {
            column,
            height,
            start: 0,
        };
        while let Some(last) = used.checked_sub(1).and_then(|i| vertices.get(i)) {
            if last.at(last.start) > new.at(last.start) {
                used -= 1; // hidden altogether
                continue;
            }
            // Where the two cross; not before the last one's start, so the difference is not negative.
            let (a, b) = (column * column + height, last.column * last.column + last.height);
            new.start = 1 + a.saturating_sub(b) / (2 * (column - last.column)).max(1);
            break;
        }
        if new.start < width
            && let Some(slot) = vertices.get_mut(used)
        {
            *slot = new;
            used += 1;
        }
    }
    Envelope(vertices.get(..used).unwrap_or_default())
}

/// The lower envelope of a row; without vertices nothing is within reach.
#[derive(Clone, Copy, Debug)]
pub(super) struct Envelope<'a>(&'a [EnvelopeVertex]);

impl Envelope<'_> {
    /// Writes the squared distances of the cells from `left` on, at most `cap`.
    #[inline(always)]
    pub(super) fn write<D: DistanceCell>(&self, left: u32, row: &mut [D], cap: u32) {
        if self.0.is_empty() {
            row.fill(D::new(false, cap));
        }
        let after = self.0.iter().skip(1).map(|vertex| vertex.start).chain([u32::MAX]);
        for (vertex, end) in self.0.iter().zip(after) {
            let index = |x: u32| (x.saturating_sub(left) as usize).min(row.len());
            let (start, end) = (index(vertex.start), index(end));
            for (cell, x) in row
                .get_mut(start..end)
                .unwrap_or_default()
                .iter_mut()
                .zip(left + start as u32..)
            {
                *cell = D::new(false, vertex.at(x).min(cap));
            }
        }
    }

    /// The squared distance of a cell not to the left of the one asked before, at most `cap`.
    #[inline(always)]
    pub(super) fn next(&mut self, x: u32, cap: u32) -> u32 {
        while let [_, rest @ ..] = self.0
            && rest.first().is_some_and(|vertex| vertex.start <= x)
        {
            self.0 = rest;
        }
        self.0.first().map_or(cap, |vertex| vertex.at(x).min(cap))
    }
}
