use super::CellValue;
use super::changes::Changes;
use super::field::FieldCell;
use super::tables::CostTables;
use crate::geometry::Bounds;

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
