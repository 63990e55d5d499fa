use super::CellValue;
use super::changes::Changes;
use super::field::FieldCell;
use super::kernel::low_bits;
use super::tables::CostTables;
use crate::geometry::{Bounds, CellRect};

/// Brings what readers see up to date after cells of the field were written: the kept cost
/// bytes, where there are any, and the rectangle of changes.
pub(crate) struct Refresh<'b, V, F: FieldCell> {
    pub values: &'b [V],
    pub tables: &'b CostTables<F>,
    pub costs: Option<&'b mut [u8]>,
    pub changes: &'b Changes<'b>,
    pub changed: &'b mut Bounds,
    pub width: u32,
}

impl<V: CellValue, F: FieldCell> Refresh<'_, V, F> {
    /// All cells of a rectangle may have new fields.
    pub(crate) fn rect(&mut self, field: &[F], rect: CellRect) {
        if self.costs.is_none() {
            self.changed.add_rect(rect);
            return;
        }
        for gy in rect.y0..rect.y1 {
            for x0 in (rect.x0..rect.x1).step_by(32) {
                let x1 = rect.x1.min(x0 + 32);
                let start = gy as usize * self.width as usize;
                let row = field
                    .get(start + x0 as usize..start + x1 as usize)
                    .unwrap_or_default();
                self.cells(row, x0, gy, low_bits(x1 - x0));
            }
        }
    }

    /// Cells of row `gy` from column `x0` on, those whose bits are set, now have these fields.
    #[inline]
    pub(crate) fn cells(&mut self, field: &[F], x0: u32, gy: u32, mut mask: u32) {
        if mask == 0 {
            return;
        }
        let first = gy as usize * self.width as usize + x0 as usize;
        let Some(costs) = &mut self.costs else {
            let (low, high) = (mask.trailing_zeros(), 32 - mask.leading_zeros());
            self.changed.add_span(x0 + low, x0 + high, gy);
            return;
        };
        let per_row = crate::storage::words_per_row(self.width);
        while mask != 0 {
            let lane = mask.trailing_zeros();
            mask &= mask - 1;
            let (i, gx) = (first + lane as usize, x0 + lane);
            // A cell whose value changed is written once, at the end of the update.
            let word = self.changes.word(gy as usize * per_row + gx as usize / 32);
            if word >> (gx % 32) & 1 == 1 {
                continue;
            }
            if let Some(cost) = costs.get_mut(i)
                && let Some(value) = self.values.get(i)
                && let Some(&field) = field.get(lane as usize)
            {
                let new = self.tables.cost(value.byte(), field);
                if core::mem::replace(cost, new) != new {
                    self.changed.add(gx, gy);
                }
            }
        }
    }
}
