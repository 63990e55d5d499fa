use super::CellValue;
use super::changes::Changes;
use super::field::FieldCell;
use super::kernel::low_bits;
use super::tables::CostTables;
use crate::geometry::{Bounds, CellRect};
use crate::storage::bits_at;

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
            let start = gy as usize * self.width as usize;
            let row = field.get(start + rect.x0 as usize..start + rect.x1 as usize);
            let mut x0 = rect.x0;
            for cells in row.unwrap_or_default().chunks(32) {
                self.cells(cells, x0, gy, low_bits(cells.len() as u32));
                x0 += 32;
            }
        }
    }

    /// Cells of row `gy` from column `x0` on, at most 32, now have these fields: those whose bits
    /// are set.
    #[inline]
    pub(crate) fn cells(&mut self, field: &[F], x0: u32, gy: u32, mut mask: u32) {
        if mask == 0 {
            return;
        }
        let Some(costs) = &mut self.costs else {
            let (low, high) = (mask.trailing_zeros(), 32 - mask.leading_zeros());
            self.changed.add_span(x0 + low, x0 + high, gy);
            return;
        };
        // A cell whose value changed is written once, at the end of the update.
        mask &= !bits_at(self.changes.row(gy), x0 as i32);
        let start = gy as usize * self.width as usize + x0 as usize;
        let cells = start..start + field.len();
        let (Some(costs), Some(values)) = (costs.get_mut(cells.clone()), self.values.get(cells)) else {
            return;
        };
        let (mut changed, mut bit) = (0, 1);
        for ((cost, value), field) in costs.iter_mut().zip(values).zip(field) {
            if mask & bit != 0 && self.tables.refresh(cost, *value, *field) {
                changed |= bit;
            }
            bit <<= 1;
        }
        if changed != 0 {
            let (low, high) = (changed.trailing_zeros(), 32 - changed.leading_zeros());
            self.changed.add_span(x0 + low, x0 + high, gy);
        }
    }
}
