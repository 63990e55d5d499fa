//! The distance field some columns at a time, one lane per cell.
//!
//! Every row in reach becomes lanes of min dx^2 over its sources; a cell is the minimum over
//! dy of the lanes dy rows above and below plus dy^2. Plain loops over bytes: a compiler turns
//! them into 16-lane instructions.

use super::super::field::FieldCell;
use super::{Disc, Kernel, Need, low_bits};
use crate::storage::{Bitmap, bits_at};

/// One row, aligned so that vector instructions take it from memory.
#[derive(Clone, Copy)]
#[cfg_attr(target_pointer_width = "64", repr(align(16)))]
struct Row<F, const LANES: usize>([F; LANES]);

/// The kernel with `LANES` columns (a divisor of 32 where single cells are recomputed) and a ring of `ROWS` rows (a power of two
/// above twice the radius).
pub(crate) struct Lanes<F, const LANES: usize, const ROWS: usize> {
    ring: [Row<F, LANES>; ROWS],
    disc: Disc,
    x0: i32,
    /// The next row to enter the ring.
    next: i32,
}

impl<F: FieldCell, const LANES: usize, const ROWS: usize> Lanes<F, LANES, ROWS> {
    pub(crate) fn new(disc: &Disc) -> Self {
        Self {
            ring: [Row([F::NONE; LANES]); ROWS],
            disc: *disc,
            x0: 0,
            next: i32::MIN,
        }
    }

    /// Makes sure that all rows in reach of row `gy` are in the ring.
    #[inline]
    fn reach(&mut self, sources: Bitmap<'_>, gy: i32) {
        let radius = self.disc.radius as i32;
        for entering in (gy - radius).max(self.next)..=gy + radius {
            self.enter(sources, entering);
        }
        self.next = gy + radius + 1;
    }

    /// The lanes of row `gy`.
    #[inline]
    fn nearest(&self, gy: i32) -> [F; LANES] {
        // From the farthest row inwards: each step inwards is 2 dy + 1 squares less.
        let radius = self.disc.radius as i32;
        let mut lanes = [F::NONE; LANES];
        for dy in (0..=radius).rev() {
            let above = &self.ring[(gy + dy) as usize % ROWS].0;
            let below = &self.ring[(gy - dy) as usize % ROWS].0;
            let inwards = F::new(2 * dy as u32 + 1);
            for ((lane, above), below) in lanes.iter_mut().zip(above).zip(below) {
                *lane = lane.saturating_add(inwards).min(*above).min(*below);
            }
        }
        let reach = F::new(self.disc.reach);
        for lane in &mut lanes {
            *lane = if *lane > reach { F::NONE } else { *lane };
        }
        lanes
    }

    /// Puts a row into the ring: lanes of min dx^2.
    #[inline]
    fn enter(&mut self, sources: Bitmap<'_>, gy: i32) {
        let row = sources.row(gy);
        let radius = self.disc.radius as i32;
        let mut lanes = [F::NONE; LANES];
        if !row.is_empty() {
            let end = self.x0 + LANES as i32 + radius;
            for x in (self.x0 - radius..end).step_by(32) {
                let mut bits = bits_at(row, x) & low_bits((end - x) as u32);
                while bits != 0 {
                    // Only the ends of a run of sources matter outside it.
                    let first = bits.trailing_zeros();
                    let run = (!(bits >> first)).trailing_zeros();
                    bits &= !(low_bits(run) << first);
                    let start = x + first as i32 - self.x0;
                    lower(&mut lanes, start);
                    if run > 1 {
                        let last = start + run as i32 - 1;
                        lower(&mut lanes, last);
                        let inside = start.max(0) as usize..(last.max(0) as usize).min(LANES);
                        for lane in lanes.get_mut(inside).unwrap_or_default() {
                            *lane = F::ZERO;
                        }
                    }
                }
            }
        }
        self.ring[gy as usize % ROWS].0 = lanes;
    }
}

/// Lowers the lanes to their squared distance from a source at lane `at`, which may lie outside.
#[inline]
fn lower<F: FieldCell, const LANES: usize>(lanes: &mut [F; LANES], at: i32) {
    if let Some(squares) = F::squares_from(-at).first_chunk::<LANES>() {
        for (lane, square) in lanes.iter_mut().zip(squares) {
            *lane = (*lane).min(*square);
        }
    }
}

impl<F: FieldCell, const LANES: usize, const ROWS: usize> Kernel<F> for Lanes<F, LANES, ROWS> {
    const LANES: u32 = LANES as u32;

    fn all(&mut self, sources: Bitmap<'_>, field: &mut [F]) {
        let width = sources.width() as usize;
        for x0 in (0..width).step_by(LANES) {
            Kernel::<F>::start(self, x0 as i32);
            for (gy, row) in (0..).zip(field.chunks_exact_mut(width)) {
                self.reach(sources, gy);
                let lanes = self.nearest(gy);
                let row = row.get_mut(x0..).unwrap_or_default();
                match row.first_chunk_mut::<LANES>() {
                    Some(row) => *row = lanes,
                    None => row.iter_mut().zip(&lanes).for_each(|(cell, lane)| *cell = *lane),
                }
            }
        }
    }

    fn start(&mut self, x0: i32) {
        self.x0 = x0;
        self.next = i32::MIN;
    }

    fn row(&mut self, sources: Bitmap<'_>, gy: i32, (need, _): (&Need<F>, u32), row: &mut [F]) -> u32 {
        let (from, to) = need.limits();
        let Some(from) = from.first_chunk::<LANES>() else {
            return 0;
        };
        let needed = |field: F, from: F| from <= field && field <= to;
        // Whole rows in arrays, so that every loop below has a fixed length.
        let mut old = [F::NONE; LANES];
        match row.first_chunk::<LANES>() {
            Some(row) => old = *row,
            None => old
                .iter_mut()
                .zip(row.iter())
                .for_each(|(old, cell)| *old = *cell),
        }
        if !matches!(need, Need::All)
            && !old
                .iter()
                .zip(from)
                .fold(false, |any, (&f, &from)| any | needed(f, from))
        {
            return 0;
        }
        self.reach(sources, gy);
        let mut lanes = self.nearest(gy);
        for ((lane, &old), &from) in lanes.iter_mut().zip(&old).zip(from) {
            *lane = if needed(old, from) { *lane } else { old };
        }
        match row.first_chunk_mut::<LANES>() {
            Some(row) => *row = lanes,
            None => row.iter_mut().zip(&lanes).for_each(|(cell, lane)| *cell = *lane),
        }
        low_bits(row.len() as u32)
    }
}
