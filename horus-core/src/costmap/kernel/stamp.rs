//! The disc of cells around one source that appears or vanishes, row by row.

use super::super::field::FieldCell;
use super::{Disc, PREFER_LANES};
use crate::geometry::CellRect;

/// Columns of a row that is treated as a whole where that is faster.
const LANES: usize = 32;
/// Rows of [`DiscRows`].
const ROWS: usize = if PREFER_LANES { 16 } else { 0 };

/// Squared distances from a source at column R of a window of 32, for dy = 0, 1, ..., R <= 15;
/// "none" outside the disc. Takes no room where it is of no use.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DiscRows<F>([[F; LANES]; ROWS]);

impl<F: FieldCell> DiscRows<F> {
    pub(crate) const EMPTY: Self = Self([[F::ZERO; LANES]; ROWS]);

    pub(crate) fn fill(&mut self, disc: Disc) {
        for (dy, lanes) in (0..).zip(&mut self.0) {
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
    /// `squared` is the cell's distance from the source; "none" changes nothing.
    #[inline(always)]
    fn apply<F: FieldCell>(self, field: F, squared: F) -> F {
        match self {
            Self::Lower => field.min(squared),
            Self::MarkStale => {
                if (field == squared) & (squared != F::NONE) {
                    F::STALE
                } else {
                    field
                }
            }
        }
    }

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
        let room = first < width && width - first >= LANES as u32;
        if room && (radius as usize) < ROWS {
            match self {
                Self::Lower => windows(field, width, rows, disc, (first, gy), |f, s| {
                    Self::Lower.apply(f, s)
                }),
                Self::MarkStale => {
                    windows(field, width, rows, disc, (first, gy), |f, s| {
                        Self::MarkStale.apply(f, s)
                    });
                }
            }
        } else {
            match self {
                Self::Lower => spans(field, width, disc, (gx, gy), |f, s| Self::Lower.apply(f, s)),
                Self::MarkStale => spans(field, width, disc, (gx, gy), |f, s| Self::MarkStale.apply(f, s)),
            }
        }
        CellRect {
            x0: gx.saturating_sub(radius),
            y0: gy.saturating_sub(radius),
            x1: width.min(gx + radius + 1),
            y1: height.min(gy + radius + 1),
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
    for (dy, squares) in rows.0.iter().enumerate().take(disc.radius as usize + 1) {
        row_at(gy + dy, squares);
        if dy > 0 && gy >= dy {
            row_at(gy - dy, squares);
        }
    }
}

/// Exactly the cells of the disc.
#[inline]
fn spans<F: FieldCell>(
    field: &mut [F],
    width: u32,
    disc: Disc,
    (gx, gy): (u32, u32),
    apply: impl Fn(F, F) -> F,
) {
    for (dy, half) in (0..).zip(disc.halves()) {
        let (x0, x1) = (gx.saturating_sub(half), (gx + half + 1).min(width));
        let squares = F::squares_from(x0 as i32 - gx as i32);
        let across = F::new(dy * dy);
        let mut row_at = |y: u32| {
            let start = y as usize * width as usize;
            let row = field
                .get_mut(start + x0 as usize..start + x1 as usize)
                .unwrap_or_default();
            for (field, square) in row.iter_mut().zip(squares) {
                *field = apply(*field, square.wrapping_add(across));
            }
        };
        row_at(gy + dy); // past the last row: no cells
        if dy > 0 && gy >= dy {
            row_at(gy - dy);
        }
    }
}
