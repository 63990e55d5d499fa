//! Window shifts: the layers move with the cells, strips along the edges wait to be recomputed.

use super::field::FieldCell;
use super::layer::{Cursors, Layer};
use crate::geometry::CellRect;
use crate::storage::{self, words_per_row};

impl<F: FieldCell> Layer<'_, F> {
    /// The window moved by whole cells; the cells themselves have already moved.
    pub(crate) fn shift(&mut self, shift: [i32; 2], unknown: u8) {
        let [dx, dy] = shift;
        if dx == 0 && dy == 0 {
            return;
        }
        self.moved = true;
        let unknown_is_source = self.tables.is_source(unknown);
        let new_cost = if unknown_is_source {
            self.tables.cost(unknown, F::ZERO)
        } else {
            super::UNKNOWN_COST
        };
        if let Some(costs) = &mut self.costs {
            storage::shift_cells(costs, self.width, self.height, shift, new_cost);
        }
        if dx.unsigned_abs() >= self.width || dy.unsigned_abs() >= self.height {
            self.changes.clear();
            self.edges.clear();
            storage::fill(self.field, if unknown_is_source { F::ZERO } else { F::NONE });
            self.sources.fill(0);
            if unknown_is_source {
                self.set_sources(CellRect {
                    x0: 0,
                    y0: 0,
                    x1: self.width,
                    y1: self.height,
                });
            }
            return;
        }
        storage::shift_bits(self.sources, self.width, self.height, shift);
        self.changes.shift(shift);
        self.cursors = Cursors::default();
        // New cells start at distance 0: never too cheap before they have been recomputed.
        storage::shift_cells(self.field, self.width, self.height, shift, F::ZERO);
        self.edges.shift(shift, self.tables.disc.radius);
        if unknown_is_source {
            self.expose_sources(shift);
        }
    }

    #[inline(never)]
    fn set_sources(&mut self, rect: CellRect) {
        let per_row = words_per_row(self.width);
        for gy in rect.y0..rect.y1 {
            for gx in rect.x0..rect.x1 {
                let w = gy as usize * per_row + gx as usize / 32;
                if let Some(word) = self.sources.get_mut(w) {
                    *word |= 1 << (gx % 32);
                }
            }
        }
    }

    /// Cells that came into view are sources: they lower the field along a straight line each.
    fn expose_sources(&mut self, [dx, dy]: [i32; 2]) {
        let (w, h) = (self.width, self.height);
        let (ax, ay) = (dx.unsigned_abs(), dy.unsigned_abs());
        let columns = if dx > 0 { w - ax..w } else { 0..ax };
        let rows = if dy > 0 { h - ay..h } else { 0..ay };
        self.set_sources(CellRect {
            x0: columns.start,
            y0: 0,
            x1: columns.end,
            y1: h,
        });
        self.set_sources(CellRect {
            x0: 0,
            y0: rows.start,
            x1: w,
            y1: rows.end,
        });
        for away in 1..=self.tables.disc.radius {
            let beside = if dx > 0 {
                columns.start.checked_sub(away)
            } else {
                Some(columns.end + away - 1)
            };
            if let Some(gx) = beside.filter(|gx| ax > 0 && *gx < w) {
                (0..h).for_each(|gy| self.lower(gx, gy, away));
            }
            let beside = if dy > 0 {
                rows.start.checked_sub(away)
            } else {
                Some(rows.end + away - 1)
            };
            if let Some(gy) = beside.filter(|gy| ay > 0 && *gy < h) {
                (0..w).for_each(|gx| self.lower(gx, gy, away));
            }
        }
    }

    /// A source lies `away` cells from this one, along an axis.
    #[inline(never)]
    fn lower(&mut self, gx: u32, gy: u32, away: u32) {
        let i = gy as usize * self.width as usize + gx as usize;
        let new = F::new(away * away);
        if let Some(field) = self.field.get_mut(i)
            && new < *field
        {
            *field = new;
            if self.costs.is_some() {
                self.mark(gx, gy); // its kept cost follows with the next update
            }
        }
    }
}
