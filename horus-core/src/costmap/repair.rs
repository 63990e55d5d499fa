//! Recomputing the field where it may be wrong.

use super::CellValue;
use super::edges::{Edge, Side};
use super::field::FieldCell;
use super::kernel::{Job, Kernel, Lanes, Need};
use super::refresh::Refresh;
use crate::geometry::CellRect;
use crate::storage::Bitmap;

/// Which cells of a region must be recomputed.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Scope {
    All,
    /// Those marked stale; with one source gone, the row it stood in.
    Stale {
        around: Option<u32>,
    },
    /// Those along an edge whose nearest source may have left the window, or that came into view.
    Edge(Side, Edge),
}

impl Scope {
    /// The same for a row from column `x0` on.
    fn need<F: FieldCell>(self, x0: u32, gy: u32, width: u32, height: u32) -> Need<F> {
        let (side, edge) = match self {
            Self::All => return Need::All,
            Self::Stale { .. } => return Need::Stale,
            Self::Edge(side, edge) => (side, edge),
        };
        let mut least = Lanes([F::ZERO; 32]);
        for (gx, lane) in (x0..width).zip(&mut least.0) {
            let from_edge = match side {
                Side::Left => gx,
                Side::Right => width - 1 - gx,
                Side::Bottom => gy,
                Side::Top => height - 1 - gy,
            };
            // A source that left lay before `lost`; a cell that had it as its nearest is at least
            // that far from it.
            let away = (from_edge + 1).saturating_sub(edge.lost);
            *lane = F::new(away.saturating_mul(away));
        }
        Need::AtLeast(least)
    }

    /// No cell of row `gy` that must be recomputed has a squared distance below the square of
    /// this: it had a source that far away or farther, and now has one farther still.
    fn least(self, gy: u32) -> u32 {
        match self {
            Self::Stale { around: Some(source) } => gy.abs_diff(source),
            _ => 0,
        }
    }

    /// True if every row needs the same.
    fn is_uniform(self) -> bool {
        !matches!(self, Self::Edge(Side::Bottom | Side::Top, _))
    }
}

/// A region of at most 32 columns to be recomputed with whichever kernel is chosen.
pub(crate) struct Repair<'b, 'r, V, F: FieldCell> {
    pub sources: Bitmap<'b>,
    pub field: &'b mut [F],
    pub rect: CellRect,
    pub scope: Scope,
    pub refresh: &'b mut Refresh<'r, V, F>,
}

impl<V: CellValue, F: FieldCell> Job<F> for Repair<'_, '_, V, F> {
    fn is_dense(&self) -> bool {
        matches!(self.scope, Scope::All)
    }

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
        let mut need = self.scope.need(x0, self.rect.y0, width, height);
        for gy in self.rect.y0..self.rect.y1 {
            let start = gy as usize * width as usize + x0 as usize;
            let end = start + (x1 - x0) as usize;
            let Some(row) = self.field.get_mut(start..end) else {
                return;
            };
            if !self.scope.is_uniform() {
                need = self.scope.need(x0, gy, width, height);
            }
            let least = self.scope.least(gy);
            let written = kernel.row(self.sources, gy as i32, (&need, least), row);
            self.refresh.cells(row, x0, gy, written);
        }
    }
}
