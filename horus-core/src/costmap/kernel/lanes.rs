//! The distance field some columns at a time, one lane per cell.
//!
//! Every row in reach becomes lanes of min dx^2 over its sources; a cell is the minimum over
//! dy of the lanes dy rows above and below plus dy^2. Plain loops over bytes: a compiler turns
//! them into 16-lane instructions.

use super::super::field::FieldCell;
use super::{Disc, Kernel};
use crate::storage::{Bitmap, bits_at};

/// The kernel with `LANES` columns (a divisor of 32) and a ring of `ROWS` rows (a power of two
/// above twice the radius).
pub(crate) struct Lanes<F, const LANES: usize, const ROWS: usize> {
    ring: [[F; LANES]; ROWS],
    /// True for rows of the ring that have a source in reach.
    occupied: [bool; ROWS],
    disc: Disc,
    x0: i32,
    /// The next row to enter the ring.
    next: i32,
}

impl<F: FieldCell, const LANES: usize, const ROWS: usize> Lanes<F, LANES, ROWS> {
    pub(crate) fn new(disc: &Disc) -> Self {
        Self {
            ring: [[F::NONE; LANES]; ROWS],
            occupied: [false; ROWS],
            disc: *disc,
            x0: 0,
            next: i32::MIN,
        }
    }

    /// Puts a row into the ring: lanes of min dx^2.
    #[inline]
    fn enter(&mut self, sources: Bitmap<'_>, gy: i32) {
        let row = sources.row(gy);
        let radius = self.disc.radius as i32;
        let slot = gy as usize % ROWS;
        let mut lanes = [F::NONE; LANES];
        let mut any = false;
        if !row.is_empty() {
            let first = self.x0 - radius;
            let end = self.x0 + LANES as i32 + radius;
            let mut x = first;
            while x < end {
                let mut bits = bits_at(row, x);
                if end - x < 32 {
                    bits &= (1 << (end - x)) - 1;
                }
                any |= bits != 0;
                while bits != 0 {
                    let column = x + bits.trailing_zeros() as i32;
                    bits &= bits - 1;
                    let squares = F::squares_from(self.x0 - column);
                    if let Some(squares) = squares.first_chunk::<LANES>() {
                        for (lane, square) in lanes.iter_mut().zip(squares) {
                            *lane = (*lane).min(*square);
                        }
                    }
                }
                x += 32;
            }
        }
        self.ring[slot] = lanes;
        self.occupied[slot] = any;
    }
}

impl<F: FieldCell, const LANES: usize, const ROWS: usize> Kernel<F> for Lanes<F, LANES, ROWS> {
    const LANES: u32 = LANES as u32;

    fn start(&mut self, x0: i32) {
        self.x0 = x0;
        self.next = i32::MIN;
    }

    fn row(&mut self, sources: Bitmap<'_>, gy: i32, mask: u32, row: &mut [F]) {
        let radius = self.disc.radius as i32;
        for entering in (gy - radius).max(self.next)..=gy + radius {
            self.enter(sources, entering);
        }
        self.next = gy + radius + 1;
        let mut lanes = [F::NONE; LANES];
        for dy in 0..=radius {
            let (above, below) = ((gy + dy) as usize % ROWS, (gy - dy) as usize % ROWS);
            if !(self.occupied[above] || self.occupied[below]) {
                continue;
            }
            let squared = F::new((dy * dy) as u32);
            let (above, below) = (&self.ring[above], &self.ring[below]);
            for ((lane, a), b) in lanes.iter_mut().zip(above).zip(below) {
                *lane = (*lane).min((*a).min(*b).saturating_add(squared));
            }
        }
        let reach = F::new(self.disc.reach);
        for lane in &mut lanes {
            *lane = if *lane > reach { F::NONE } else { *lane };
        }
        if mask == super::low_bits(LANES as u32) && row.len() >= LANES {
            for (cell, lane) in row.iter_mut().zip(&lanes) {
                *cell = *lane;
            }
        } else {
            for (i, (cell, lane)) in row.iter_mut().zip(&lanes).enumerate() {
                if mask >> i & 1 == 1 {
                    *cell = *lane;
                }
            }
        }
    }
}
