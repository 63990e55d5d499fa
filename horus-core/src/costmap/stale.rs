//! Cells whose nearest source may have vanished: marked, then recomputed.

use super::CellValue;
use super::field::FieldCell;
use super::kernel::stamp::Stamp;
use super::layer::Layer;
use super::repair::Scope;
use crate::geometry::{Bounds, CellRect};

/// Where cells were marked stale.
#[derive(Debug)]
pub(super) struct Stale {
    bounds: Bounds,
    sources: u32,
    /// The row of the latest source that vanished.
    row: u32,
}

impl Default for Stale {
    fn default() -> Self {
        Self {
            bounds: Bounds::EMPTY,
            sources: 0,
            row: 0,
        }
    }
}

impl Stale {
    /// One more source vanished, in row `gy`; `rect` holds its disc.
    fn add(&mut self, rect: CellRect, gy: u32) {
        self.bounds.add_rect(rect);
        self.sources += 1;
        self.row = gy;
    }

    /// The row of the source, if there is only one.
    fn around(&self) -> Option<u32> {
        (self.sources == 1).then_some(self.row)
    }
}

impl<F: FieldCell> Layer<'_, F> {
    /// Marks the cells whose nearest source may have been this one.
    pub(super) fn mark_stale(&mut self, gx: u32, gy: u32, stale: &mut Stale) {
        let size = (self.width, self.height);
        let rect = Stamp::MarkStale.disc(self.field, size, self.tables.disc, &self.tables.rows, (gx, gy));
        let strips = rect.x0 as usize / 32..rect.x1.div_ceil(32) as usize;
        for [first, end] in self.stale_rows.get_mut(strips).unwrap_or_default() {
            *first = if *end == 0 { rect.y0 } else { rect.y0.min(*first) };
            *end = rect.y1.max(*end);
        }
        stale.add(rect, gy);
    }

    /// Recomputes the cells marked stale.
    pub(super) fn repair_stale<V: CellValue>(
        &mut self,
        stale: &mut Stale,
        values: &[V],
        changed: &mut Bounds,
    ) {
        let stale = core::mem::take(stale);
        let Some(rect) = stale.bounds.rect() else {
            return;
        };
        let scope = Scope::Stale {
            around: stale.around(),
        };
        let strips = rect.x0 as usize / 32..rect.x1.div_ceil(32) as usize;
        if rect.width() <= 32 {
            self.stale_rows.get_mut(strips).unwrap_or_default().fill([0; 2]);
            self.repair(rect, scope, values, changed);
            return;
        }
        for strip in strips {
            let Some([y0, y1]) = self.stale_rows.get_mut(strip).map(core::mem::take) else {
                return;
            };
            let rect = CellRect {
                x0: strip as u32 * 32,
                y0,
                x1: self.width.min(strip as u32 * 32 + 32),
                y1,
            };
            if y1 != 0 {
                self.repair(rect, scope, values, changed);
            }
        }
    }

    /// So much changed that recomputing everything is cheaper; the sources are up to date.
    pub(super) fn repair_all<V: CellValue>(&mut self, values: &[V], changed: &mut Bounds) {
        self.stale_rows.fill([0; 2]);
        for x0 in (0..self.width).step_by(32) {
            let rect = CellRect {
                x0,
                y0: 0,
                x1: self.width.min(x0 + 32),
                y1: self.height,
            };
            self.repair(rect, Scope::All, values, changed);
        }
    }
}
