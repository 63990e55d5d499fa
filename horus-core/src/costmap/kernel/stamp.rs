//! The disc of cells around one source that appears or vanishes, row by row.

use super::super::field::FieldCell;
use super::{Disc, PREFER_LANES};
use crate::geometry::CellRect;

/// Columns of a row that is treated as a whole where that is faster.
const LANES: usize = 32;
/// Rows of [`DiscRows::squares`].
const ROWS: usize = if PREFER_LANES { 16 } else { 0 };

/// The rows of a disc of up to 15 cells of radius, for dy = 0, 1, ..., R.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DiscRows<F> {
    /// The largest dx still in the disc.
    halves: [u8; 16],
    /// Squared distances from a source at column R of a window of 32; "none" outside the disc.
    /// Takes no room where it is of no use.
    squares: [[F; LANES]; ROWS],
}

impl<F: FieldCell> DiscRows<F> {
    pub(crate) const EMPTY: Self = Self {
        halves: [0; 16],
        squares: [[F::ZERO; LANES]; ROWS],
    };

    pub(crate) fn fill(&mut self, disc: Disc) {
        for (to, half) in self.halves.iter_mut().zip(disc.halves()) {
            *to = half as u8;
        }
        for (dy, lanes) in (0..).zip(&mut self.squares) {
            for (x, lane) in (0..).zip(lanes) {
                let dx = disc.radius.abs_diff(x);
                let squared = dx * dx + dy * dy;
                *lane = if squared > disc.reach {
                    F::NONE
                } else {
                    F::new(squared)
                };
            }
        }
    }
}

/// What to do to the cells of a disc.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stamp {
    /// The source appears: cells are lowered to their distance from it.
    Lower,
    /// The source vanishes: cells whose nearest it may have been are marked stale.
    MarkStale,
}

impl Stamp {
    /// Applies the stamp around the source (gx, gy); returns the disc's box inside the map.
    pub(crate) fn disc<F: FieldCell>(
        self,
        field: &mut [F],
        (width, height): (u32, u32),
        disc: Disc,
        rows: &DiscRows<F>,
        (gx, gy): (u32, u32),
    ) -> CellRect {
        let radius = disc.radius;
        let first = gx.wrapping_sub(radius);
        let whole = (radius as usize) < ROWS && first < width && width - first >= LANES as u32;
        let size = (width, height);
        let narrow = disc.reach < F::NARROW;
        match self {
            Self::Lower if !whole && narrow => spans(
                field,
                size,
                disc,
                rows,
                (gx, gy),
                lower_row::<F, false>,
                |rows, squares, across| F::lower::<false>(rows, squares, across),
            ),
            Self::Lower if !whole => spans(
                field,
                size,
                disc,
                rows,
                (gx, gy),
                lower_row::<F, true>,
                |rows, squares, across| F::lower::<true>(rows, squares, across),
            ),
            Self::MarkStale if !whole => spans(
                field,
                size,
                disc,
                rows,
                (gx, gy),
                mark_row,
                |rows, squares, across| F::mark_stale(rows, squares, across),
            ),
            Self::Lower => windows(field, width, rows, disc, (first, gy), |f, s| f.min(s)),
            Self::MarkStale => windows(field, width, rows, disc, (first, gy), |f, s| {
                if (f == s) & (s != F::NONE) { F::STALE } else { f }
            }),
        }
        CellRect {
            x0: gx.saturating_sub(radius),
            y0: gy.saturating_sub(radius),
            x1: width.min(gx + radius + 1),
            y1: height.min(gy + radius + 1),
        }
    }
}

#[inline(never)]
fn lower_row<F: FieldCell, const WIDE: bool>(row: &mut [F], squares: &[F], across: u32) {
    F::lower::<WIDE>([row, &mut []], squares, across);
}

#[inline(never)]
fn mark_row<F: FieldCell>(row: &mut [F], squares: &[F], across: u32) {
    F::mark_stale([row, &mut []], squares, across);
}

/// Exactly the cells of the disc. Given rows, their columns' squares, and dy^2: `single` changes
/// one row, `pair` two.
#[inline(always)]
fn spans<F: FieldCell>(
    field: &mut [F],
    (width, height): (u32, u32),
    disc: Disc,
    rows: &DiscRows<F>,
    (gx, gy): (u32, u32),
    single: impl Fn(&mut [F], &[F], u32),
    pair: impl Fn([&mut [F]; 2], &[F], u32),
) {
    let radius = disc.radius;
    let inside = |g: u32, size: u32| g >= radius && g < size.saturating_sub(radius);
    let row = gy as usize * width as usize;
    if radius < rows.halves.len() as u32 && inside(gx, width) && inside(gy, height) {
        let (below, above) = field.split_at_mut_checked(row).unwrap_or_default();
        let halves = rows.halves.get(..=radius as usize).unwrap_or_default();
        pairs(below, above, width as usize, gx as usize, halves, single, pair);
        return;
    }
    // The source's column in the rows above and below.
    let (mut up, mut down) = (row + gx as usize, row + gx as usize);
    for (dy, half) in (0..).zip(disc.halves()) {
        let (left, right) = (half.min(gx) as usize, half.min(width - 1 - gx) as usize);
        let squares = F::squares_from(-(left as i32));
        let mut row_at = |centre: usize| {
            // Beyond the first and the last row there are no cells.
            if let Some(row) = field.get_mut(centre - left..centre + right + 1) {
                single(row, squares, dy * dy);
            }
        };
        row_at(up);
        if dy > 0 && dy <= gy {
            down -= width as usize;
            row_at(down);
        }
        up += width as usize;
    }
}

/// The same for a near disc inside the map: rows above and below the source in pairs.
#[inline(always)]
fn pairs<F: FieldCell>(
    below: &mut [F],
    above: &mut [F],
    width: usize,
    gx: usize,
    halves: &[u8],
    single: impl Fn(&mut [F], &[F], u32),
    pair: impl Fn([&mut [F]; 2], &[F], u32),
) {
    let Some((&half, halves)) = halves.split_first() else {
        return;
    };
    let columns = |centre: usize, half: usize| centre.wrapping_sub(half)..centre + half + 1;
    let (mut up, mut down) = (gx, below.len() + gx);
    if let Some(row) = above.get_mut(columns(up, half.into())) {
        single(row, F::squares_from(-i32::from(half)), 0);
    }
    let mut across = 0;
    let mut next = 1;
    for half in halves {
        let half = usize::from(*half);
        across += next; // dy^2
        next += 2;
        up += width;
        down = down.wrapping_sub(width);
        if let Some(above) = above.get_mut(columns(up, half))
            && let Some(below) = below.get_mut(columns(down, half))
        {
            pair([above, below], F::squares_from(-(half as i32)), across);
        }
    }
}

/// Rows of 32 whole cells from column `first` on.
#[inline]
fn windows<F: FieldCell>(
    field: &mut [F],
    width: u32,
    rows: &DiscRows<F>,
    disc: Disc,
    (first, gy): (u32, u32),
    apply: impl Fn(F, F) -> F,
) {
    let (width, first, gy) = (width as usize, first as usize, gy as usize);
    let mut row_at = |y: usize, squares: &[F; LANES]| {
        let row = field
            .get_mut(y * width + first..)
            .and_then(|r| r.first_chunk_mut::<LANES>());
        // Past the last row there is no such chunk, or one that belongs to no row of the map.
        if let Some(row) = row {
            for (field, square) in row.iter_mut().zip(squares) {
                *field = apply(*field, *square);
            }
        }
    };
    for (dy, squares) in rows.squares.iter().enumerate().take(disc.radius as usize + 1) {
        row_at(gy + dy, squares);
        if dy > 0 && gy >= dy {
            row_at(gy - dy, squares);
        }
    }
}
