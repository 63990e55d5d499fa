//! The distance field of near discs four cells per word, for cores whose instructions take the
//! minimum of four bytes at once (Cortex-M4, M7 and M33 with the `dsp` feature).
//!
//! Every row in reach becomes words of min dx^2 over its sources; a cell is the minimum over dy of
//! the cells dy rows above and below plus dy^2.

use super::super::dsp::{add, min, select};
use super::super::field::FieldCell;
use super::super::words::every;
use super::{Disc, Kernel, Need, low_bits};
use crate::storage::{Bitmap, bits_at};

/// Words of a row of 32 cells.
const ROW: usize = 8;
/// Rows in reach of a row, at most; every row lies in the ring twice, this far apart, so that any
/// such stretch is in one piece.
const ROWS: usize = 32;
/// Words that are held in registers while they are compared with all rows; more do not fit.
const GROUP: usize = 2;
const NONE: u32 = every(u8::NONE);

/// The kernel, for radii up to 15 cells.
pub(crate) struct Quads<'a> {
    ring: &'a mut [[[u32; ROW]; ROWS]; 2],
    /// The rows of the ring, a bit each, that have a source in reach of the strip.
    occupied: u32,
    disc: Disc,
    x0: i32,
    /// The next row to enter the ring.
    next: i32,
}

impl<'a> Quads<'a> {
    pub(crate) fn new(disc: &Disc, ring: &'a mut [u32]) -> Option<Self> {
        let rows = ring.as_chunks_mut().0;
        let ring = rows.as_chunks_mut().0.first_chunk_mut()?;
        Some(Self {
            ring,
            occupied: 0,
            disc: *disc,
            x0: 0,
            next: i32::MIN,
        })
    }

    /// Makes sure that all rows in reach of row `gy` are in the ring.
    #[inline]
    fn reach(&mut self, sources: Bitmap<'_>, gy: i32) {
        let radius = self.disc.radius as i32;
        for entering in (gy - radius).max(self.next)..gy + radius + 1 {
            self.enter(sources, entering);
        }
        self.next = gy + radius + 1;
    }

    /// Puts a row into the ring: min dx^2 of every cell.
    fn enter(&mut self, sources: Bitmap<'_>, gy: i32) {
        let [once, twice] = &mut self.ring;
        let slot = gy as usize % ROWS;
        let words = &mut once[slot];
        let any = min_squares(words, sources.row(gy), self.x0, self.disc.radius as i32);
        twice[slot] = *words;
        self.occupied = self.occupied & !(1 << slot) | u32::from(any) << slot;
    }

    /// The squared distances of the 32 cells of row `gy`.
    #[inline]
    fn nearest(&self, gy: i32) -> [u32; ROW] {
        let mut nearest = [NONE; ROW];
        let first = gy.wrapping_sub(self.disc.radius as i32) as u32 % ROWS as u32;
        let occupied = self.occupied.rotate_right(first) & low_bits(self.disc.side());
        if occupied == 0 {
            return nearest;
        }
        let (first, radius) = (first as usize, self.disc.radius as usize);
        let Some(rows) = self.ring.as_flattened().get(first..first + 2 * radius + 1) else {
            return nearest;
        };
        let Some((below, [here, above @ ..])) = rows.split_at_checked(radius) else {
            return nearest;
        };
        // 254 and 255 are no distances.
        let beyond = every(self.disc.reach.min(253) as u8 + 1);
        for (group, i) in nearest
            .as_chunks_mut::<GROUP>()
            .0
            .iter_mut()
            .zip((0..ROW).step_by(GROUP))
        {
            // From the farthest rows inwards: each step inwards is 2 dy + 1 squares less.
            let mut inwards = every(2 * radius as u8 + 1);
            for (above, below) in above.iter().rev().zip(below) {
                for (j, word) in group.iter_mut().enumerate() {
                    *word = min(min(add(*word, inwards), above[i + j]), below[i + j]);
                }
                inwards = inwards.wrapping_sub(every(2));
            }
            for (j, word) in group.iter_mut().enumerate() {
                *word = min(add(*word, every(1)), here[i + j]);
                *word = select(*word, beyond, NONE, *word);
            }
        }
        nearest
    }
}

/// Writes min dx^2 of the 32 cells of a row of sources from column `x0` on; false if no source
/// lies within the radius of any.
fn min_squares(words: &mut [u32; ROW], row: &[u32], x0: i32, radius: i32) -> bool {
    *words = [NONE; ROW];
    let mut any = false;
    if row.is_empty() {
        return any;
    }
    let end = x0 + 32 + radius;
    for x in [x0 - radius, x0 - radius + 32] {
        let mut bits = bits_at(row, x) & low_bits((end - x) as u32);
        any |= bits != 0;
        while bits != 0 {
            // Only the ends of a run of sources matter outside it.
            let first = bits.trailing_zeros();
            let run = (!(bits >> first)).trailing_zeros();
            bits &= !(low_bits(run) << first);
            let start = x - x0 + first as i32;
            lower(words, start);
            if run > 1 {
                lower(words, start + run as i32 - 1);
            }
        }
    }
    let mut here = bits_at(row, x0);
    for word in words {
        if here == 0 {
            break;
        }
        // Four bits become four bytes, each all zeros or all ones.
        let are_sources = ((here & 15).wrapping_mul(0x0020_4081) & every(1)) * 255;
        *word &= !are_sources;
        here >>= 4;
    }
    any
}

/// Lowers the cells to their squared distance from a source at cell `at`, which may lie outside.
#[inline]
fn lower(words: &mut [u32; ROW], at: i32) {
    if let Some(squares) = u8::squares_from(-at).first_chunk::<32>() {
        for (word, squares) in words.iter_mut().zip(squares.as_chunks().0) {
            *word = min(*word, u32::from_le_bytes(*squares));
        }
    }
}

impl<F: FieldCell> Kernel<F> for Quads<'_> {
    const LANES: u32 = 32;

    fn all(&mut self, sources: Bitmap<'_>, field: &mut [F]) {
        let width = sources.width() as usize;
        for x0 in (0..width).step_by(32) {
            Kernel::<F>::start(self, x0 as i32);
            for (gy, row) in (0..).zip(field.chunks_exact_mut(width)) {
                self.reach(sources, gy);
                let row = row.get_mut(x0..).unwrap_or_default();
                let nearest = self.nearest(gy);
                match row.first_chunk_mut::<32>() {
                    Some(row) => {
                        for (cells, word) in row.as_chunks_mut().0.iter_mut().zip(nearest) {
                            *cells = word.to_le_bytes().map(F::from_near);
                        }
                    }
                    None => store(row, &nearest, u32::MAX),
                }
            }
        }
    }

    fn start(&mut self, x0: i32) {
        self.x0 = x0;
        self.next = i32::MIN;
    }

    fn row(&mut self, sources: Bitmap<'_>, gy: i32, (need, _): (&Need<F>, u32), row: &mut [F]) -> u32 {
        let mask = need.mask(row);
        if mask != 0 {
            self.reach(sources, gy);
            store(row, &self.nearest(gy), mask);
        }
        mask
    }
}

/// Writes the cells whose bits are set, of up to 32.
#[inline]
fn store<F: FieldCell>(row: &mut [F], words: &[u32; ROW], mut mask: u32) {
    let (whole, rest) = row.as_chunks_mut::<4>();
    let mut words = words.iter();
    for (cells, word) in whole.iter_mut().zip(&mut words) {
        if mask & 15 == 15 {
            *cells = word.to_le_bytes().map(F::from_near);
        } else if mask & 15 != 0 {
            keep(cells, word, mask);
        }
        mask >>= 4;
    }
    if let Some(word) = words.next() {
        keep(rest, word, mask);
    }
}

/// The same for the cells of one word.
fn keep<F: FieldCell>(cells: &mut [F], word: &u32, mask: u32) {
    for (i, (cell, new)) in cells.iter_mut().zip(word.to_le_bytes()).enumerate() {
        if mask >> i & 1 == 1 {
            *cell = F::from_near(new);
        }
    }
}
