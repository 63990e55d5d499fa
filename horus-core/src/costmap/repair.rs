//! Recomputing the field where it may be wrong.

use super::CellValue;
use super::edges::{Edge, Side};
use super::field::FieldCell;
use super::kernel::{Job, Kernel, low_bits};
use super::refresh::Refresh;
use crate::geometry::CellRect;
use crate::storage::Bitmap;

/// Which cells of a region must be recomputed.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Need {
    All,
    /// Those marked stale.
    Stale,
    /// Those along an edge whose nearest source may have left the window, or that came into view.
    Edge(Side, Edge),
}

impl Need {
    /// The lanes of a row segment that must be recomputed; its first cell is (x0, gy).
    #[inline]
    fn mask<F: FieldCell>(self, row: &[F], x0: u32, gy: u32, width: u32, height: u32) -> u32 {
        match self {
            Self::All => low_bits(row.len() as u32),
            Self::Stale => lanes(row, |_, field| field == F::STALE),
            Self::Edge(side, edge) => {
                // A source that left lay before `lost`; a cell that had it as its nearest is at
                // least that far from it.
                let needs = |from_edge: u32, field: F| {
                    let away = (from_edge + 1).saturating_sub(edge.lost);
                    field != F::NONE && field.squared() >= away * away
                };
                lanes(row, |lane, field| match side {
                    Side::Left => needs(x0 + lane, field),
                    Side::Right => needs(width - 1 - x0 - lane, field),
                    Side::Bottom => needs(gy, field),
                    Side::Top => needs(height - 1 - gy, field),
                })
            }
        }
    }
}

#[inline]
fn lanes<F: Copy>(row: &[F], mut test: impl FnMut(u32, F) -> bool) -> u32 {
    let mut mask = 0;
    for (lane, &field) in row.iter().enumerate().take(32) {
        mask |= u32::from(test(lane as u32, field)) << lane;
    }
    mask
}

/// A region of at most 32 columns to be recomputed with whichever kernel is chosen.
pub(crate) struct Repair<'b, 'r, V, F: FieldCell> {
    pub sources: Bitmap<'b>,
    pub field: &'b mut [F],
    pub rect: CellRect,
    pub need: Need,
    /// `None`: nobody has to be told.
    pub refresh: Option<&'b mut Refresh<'r, V, F>>,
}

impl<V: CellValue, F: FieldCell> Job<F> for Repair<'_, '_, V, F> {
    fn run(mut self, kernel: &mut impl Kernel<F>) {
        let mut x0 = self.rect.x0;
        while x0 < self.rect.x1 {
            let x1 = self.rect.x1.min(x0 + lanes_of(kernel));
            self.strip(kernel, x0, x1);
            x0 = x1;
        }
    }
}

fn lanes_of<F, K: Kernel<F>>(_: &K) -> u32 {
    K::LANES
}

impl<V: CellValue, F: FieldCell> Repair<'_, '_, V, F> {
    fn strip(&mut self, kernel: &mut impl Kernel<F>, x0: u32, x1: u32) {
        let (width, height) = (self.sources.width(), self.sources.height());
        kernel.start(x0 as i32);
        for gy in self.rect.y0..self.rect.y1 {
            let start = gy as usize * width as usize + x0 as usize;
            let end = start + (x1 - x0) as usize;
            let Some(row) = self.field.get_mut(start..end) else {
                return;
            };
            let mask = self.need.mask(row, x0, gy, width, height);
            if mask == 0 {
                continue;
            }
            kernel.row(self.sources, gy as i32, mask, row);
            if let Some(refresh) = &mut self.refresh {
                refresh.cells(row, x0, gy, mask);
            }
        }
    }
}
