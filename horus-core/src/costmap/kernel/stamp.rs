//! The disc of cells around one source that appears or vanishes.

use super::super::field::FieldCell;
use super::Disc;
use crate::geometry::CellRect;

/// Columns of a row that is treated as a whole.
pub(crate) const LANES: usize = 32;
/// The same for discs that are [narrow](FieldCell::is_narrow).
pub(crate) const FEW_LANES: usize = 24;
/// Columns of a disc's row: any window that holds the source finds its squares in them.
pub(crate) const COLUMNS: usize = 2 * LANES;
/// The source's column among them.
const SOURCE: u32 = LANES as u32 - 1;

/// The rows of a disc of up to 15 cells of radius, for dy = 0, 1, ..., R: squared distances from
/// the source, [`FieldCell::beyond`] outside the disc.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DiscRows<F: FieldCell>(F::Windows);

impl<F: FieldCell> DiscRows<F> {
    pub(crate) const EMPTY: Self = Self(F::NO_WINDOWS);

    pub(crate) fn fill(&mut self, disc: Disc) {
        for (dy, lanes) in (0..).zip(self.0.as_mut()) {
            for (x, lane) in (0..).zip(lanes) {
                let dx = SOURCE.abs_diff(x);
                let squared = dx * dx + dy * dy;
                *lane = if squared > disc.reach {
                    F::beyond(disc.reach)
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
        let rect = CellRect {
            x0: gx.saturating_sub(radius),
            y0: gy.saturating_sub(radius),
            x1: width.min(gx + radius + 1),
            y1: height.min(gy + radius + 1),
        };
        let around = Around {
            field,
            width,
            rect,
            gx,
            gy,
        };
        match rows.0.as_ref().get(..=radius as usize) {
            Some(rows) if width >= LANES as u32 => match self {
                Self::Lower if F::is_narrow(disc.reach) => around.windows(rows, F::lower::<FEW_LANES>),
                Self::Lower => around.windows(rows, F::lower::<LANES>),
                Self::MarkStale => around.windows(rows, F::mark_stale),
            },
            _ => around.spans(disc, |cell, squared| match self {
                Self::Lower => cell.min(squared),
                Self::MarkStale if cell == squared => F::STALE,
                Self::MarkStale => cell,
            }),
        }
        rect
    }
}

/// A source in a field, and its disc's box.
struct Around<'f, F> {
    field: &'f mut [F],
    width: u32,
    rect: CellRect,
    gx: u32,
    gy: u32,
}

impl<F: FieldCell> Around<'_, F> {
    /// In every row of the disc, a window of `N` cells that holds the disc's.
    #[inline(always)]
    fn windows<const N: usize>(self, rows: &[[F; COLUMNS]], apply: impl Fn(&mut [F; N], &[F; N])) {
        let first = self.rect.x0.min(self.width - N as u32);
        let column = (SOURCE + first - self.gx) as usize;
        let mut start = self.rect.y0 as usize * self.width as usize + first as usize;
        for y in self.rect.y0..self.rect.y1 {
            let squares = rows.get(self.gy.abs_diff(y) as usize);
            if let Some(squares) = squares.and_then(|s| s.get(column..)?.first_chunk())
                && let Some(row) = self.field.get_mut(start..).and_then(|r| r.first_chunk_mut())
            {
                apply(row, squares);
            }
            start += self.width as usize;
        }
    }

    /// Exactly the cells of the disc, one after another.
    #[inline(always)]
    fn spans(self, disc: Disc, apply: impl Fn(F, F) -> F) {
        let mut start = self.rect.y0 as usize * self.width as usize;
        let mut half = 0;
        for y in self.rect.y0..self.rect.y1 {
            let across = self.gy.abs_diff(y).pow(2);
            half = disc.half(across, half);
            let (x0, x1) = (self.gx.saturating_sub(half), self.rect.x1.min(self.gx + half + 1));
            let row = self.field.get_mut(start + x0 as usize..start + x1 as usize);
            for (x, cell) in (x0..).zip(row.unwrap_or_default()) {
                *cell = apply(*cell, F::new(self.gx.abs_diff(x).pow(2) + across));
            }
            start += self.width as usize;
        }
    }
}
