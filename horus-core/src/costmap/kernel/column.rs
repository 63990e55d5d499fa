//! The distance field one column at a time, for radii whose rows in reach would fill the stack.

use super::super::field::FieldCell;
use super::{Disc, Kernel, Need, low_bits};
use crate::storage::{Bitmap, bits_at};

/// Scratch words of a [`Column`]: a power of two above twice the largest radius.
pub(crate) const FAR_WORDS: usize = 512;

/// The kernel for one column, its ring of rows in the scratch memory.
pub(crate) struct Column<'s> {
    /// By row: the squared distance, along the row, to its source nearest to the column.
    ring: &'s mut [u32; FAR_WORDS],
    disc: Disc,
    x: i32,
    /// The next row to enter the ring.
    next: i32,
    /// The last row that had a source in reach.
    last: i32,
}

impl<'s> Column<'s> {
    /// A row without a source in reach; dy^2 can still be added.
    const NONE: u32 = u32::MAX / 2;

    pub(crate) fn new(disc: &Disc, ring: &'s mut [u32; FAR_WORDS]) -> Self {
        Self {
            ring,
            disc: *disc,
            x: 0,
            next: i32::MIN,
            last: i32::MIN,
        }
    }

    /// The field of the column's cell in row `gy`; rows come in ascending order.
    #[inline]
    fn cell<F: FieldCell>(&mut self, sources: Bitmap<'_>, gy: i32) -> F {
        let radius = self.disc.radius as i32;
        for entering in (gy - radius).max(self.next)..=gy + radius {
            let along = self.along(sources.row(entering));
            self.ring[entering as usize % FAR_WORDS] = along;
            if along != Self::NONE {
                self.last = entering;
            }
        }
        self.next = gy + radius + 1;
        if self.last < gy - radius {
            return F::NONE;
        }
        let mut nearest = Self::NONE;
        for dy in 0..=radius {
            let rise = (dy * dy) as u32;
            if rise >= nearest {
                break; // so are all rows farther away
            }
            let above = self.ring[(gy + dy) as usize % FAR_WORDS];
            let below = self.ring[(gy - dy) as usize % FAR_WORDS];
            nearest = nearest.min(above.min(below) + rise);
        }
        if nearest > self.disc.reach {
            F::NONE
        } else {
            F::new(nearest)
        }
    }

    /// The squared distance along a row from the column to the nearest source.
    #[inline]
    fn along(&self, row: &[u32]) -> u32 {
        if row.is_empty() {
            return Self::NONE;
        }
        // 32 columns to the right and to the left, the column itself in both, and on.
        for away in (0..=self.disc.radius).step_by(32) {
            let right = bits_at(row, self.x + away as i32).trailing_zeros();
            let left = bits_at(row, self.x - away as i32 - 31).leading_zeros();
            let nearest = right.min(left);
            if nearest < 32 {
                return (away + nearest).pow(2);
            }
        }
        Self::NONE
    }
}

impl<F: FieldCell> Kernel<F> for Column<'_> {
    const LANES: u32 = 1;

    fn all(&mut self, sources: Bitmap<'_>, field: &mut [F]) {
        let width = sources.width() as usize;
        for x in 0..width {
            Kernel::<F>::start(self, x as i32);
            for (gy, row) in (0..).zip(field.chunks_exact_mut(width)) {
                if let Some(cell) = row.get_mut(x) {
                    *cell = self.cell(sources, gy);
                }
            }
        }
    }

    fn start(&mut self, x0: i32) {
        self.x = x0;
        self.next = i32::MIN;
        self.last = i32::MIN;
    }

    fn row(&mut self, sources: Bitmap<'_>, gy: i32, (need, _): (&Need<F>, u32), row: &mut [F]) -> u32 {
        let Some(cell) = row.first_mut() else {
            return 0;
        };
        if !need.first(*cell) {
            return 0;
        }
        *cell = self.cell(sources, gy);
        low_bits(1)
    }
}
