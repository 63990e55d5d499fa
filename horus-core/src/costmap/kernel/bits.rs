//! The distance field 32 cells at a time, in words of bits.
//!
//! For every row in reach, and dx = 0, 1, ..., one word holds the cells with a source within dx
//! columns in that row. A cell's squared distance is then the first pair (dx, dy), in ascending
//! order of dx^2 + dy^2, for which its bit is set dy rows above or below. So a pair costs two
//! loads for 32 cells, and the search ends when all cells that have a source in reach are found.
//! On a Cortex-M4 this takes a third of the instructions of comparing bytes in u32 lanes.

use super::super::field::{FieldCell, MIDDLE_LIMIT, NEAR_LIMIT};
use super::{Disc, Kernel, Need, low_bits};
use crate::storage::{Bitmap, bits_at};

/// Scratch words for radii up to 15 cells: 32 rows of 16 words.
pub(crate) const NEAR_WORDS: usize = 32 * 16;
/// Scratch words for radii up to 31 cells: 64 rows of 32 words.
pub(crate) const MIDDLE_WORDS: usize = 64 * 32;

const NEAR_PAIRS: usize = count_pairs(NEAR_LIMIT);
const MIDDLE_PAIRS: usize = count_pairs(MIDDLE_LIMIT);
static NEAR: [u32; NEAR_PAIRS] = pairs(16, NEAR_WORDS as u32);
static MIDDLE: [u32; MIDDLE_PAIRS] = pairs(32, MIDDLE_WORDS as u32);

pub(crate) type Near<'a> = Bits<'a, 16, NEAR_WORDS>;
pub(crate) type Middle<'a> = Bits<'a, 32, MIDDLE_WORDS>;

/// For every least distance in cells, the first pair that is not nearer.
static FIRST: [u16; 32] = {
    let mut first = [0; 32];
    let mut cells = 1;
    while cells < 32 {
        first[cells] = count_pairs(cells as u32 * cells as u32 - 1) as u16;
        cells += 1;
    }
    first
};

/// The number of pairs dx, dy >= 0 with dx^2 + dy^2 <= limit.
const fn count_pairs(limit: u32) -> usize {
    let (mut n, mut dx) = (0, 0);
    while dx * dx <= limit {
        n += (limit - dx * dx).isqrt() as usize + 1;
        dx += 1;
    }
    n
}

/// The [`offsets`] of all such pairs, in ascending order of their squared distance.
const fn pairs<const N: usize>(stride: u32, words: u32) -> [u32; N] {
    let mut pairs = [0; N];
    let (mut n, mut squared) = (0, 0);
    while n < N {
        let mut dx = 0;
        while dx * dx <= squared {
            let rest: u32 = squared - dx * dx;
            let dy = rest.isqrt();
            if dy * dy == rest {
                pairs[n] = offsets(dx, dy, stride, words);
                n += 1;
            }
            dx += 1;
        }
        squared += 1;
    }
    pairs
}

/// The kernel, with rows of `STRIDE` words in a ring of `WORDS` words (both powers of two).
pub(crate) struct Bits<'a, const STRIDE: usize, const WORDS: usize> {
    ring: &'a mut [u32; WORDS],
    disc: Disc,
    /// Offsets of all pairs within reach.
    pairs: &'static [u32],
    /// Offsets of the pairs on the disc's rim: for each dy the largest dx.
    rim: [u32; STRIDE],
    x0: i32,
    /// The next row to enter the ring.
    next: i32,
    /// The latest row in the ring that has a source in reach of the strip.
    occupied: i32,
}

impl<'a, const STRIDE: usize, const WORDS: usize> Bits<'a, STRIDE, WORDS> {
    pub(crate) fn new(disc: &Disc, ring: &'a mut [u32; WORDS]) -> Self {
        let all: &'static [u32] = if STRIDE == 16 { &NEAR } else { &MIDDLE };
        let mut rim = [0; STRIDE];
        let mut count = 0;
        for (dy, (pair, half)) in (0..).zip(rim.iter_mut().zip(disc.halves())) {
            *pair = offsets(half, dy, STRIDE as u32, WORDS as u32);
            count += half as usize + 1;
        }
        Self {
            ring,
            disc: *disc,
            pairs: all.get(..count).unwrap_or(all),
            rim,
            x0: 0,
            next: i32::MIN,
            occupied: i32::MIN,
        }
    }

    fn radius(&self) -> i32 {
        self.disc.radius as i32
    }

    /// First word of a row in the ring.
    fn slot(gy: i32) -> usize {
        gy as usize % (WORDS / STRIDE) * STRIDE
    }

    /// Puts a row into the ring: word dx has the cells with a source within dx columns.
    #[inline]
    fn enter(&mut self, sources: Bitmap<'_>, gy: i32) {
        let row = sources.row(gy);
        let radius = self.disc.radius;
        // An empty row has no bits.
        let [left, here, right] = [-32, 0, 32].map(|away| bits_at(row, self.x0 + away));
        let start = Self::slot(gy);
        let Some(words) = self.ring.get_mut(start..start + STRIDE) else {
            return;
        };
        // Only bits within the radius count.
        let in_reach = here != 0 || (left >> 1 >> (31 - radius)) != 0 || right & low_bits(radius) != 0;
        if !in_reach {
            words.fill(0);
            return;
        }
        self.occupied = gy;
        let mut within = here;
        let Some((first, words)) = words.split_first_mut() else {
            return;
        };
        *first = within;
        for (dx, word) in (1..radius + 1).zip(words) {
            within |= here << dx | left >> (32 - dx) | here >> dx | right << (32 - dx);
            *word = within;
        }
    }

    /// Cells of the row at `base` that have a source in reach.
    #[inline]
    fn covered(&self, base: u32) -> u32 {
        let rim = self.rim.iter().take(self.disc.radius as usize + 1);
        rim.fold(0, |covered, &pair| covered | self.pair(base, pair))
    }

    /// The cells with a source at (dx, dy) or (dx, -dy), either way along the row.
    #[inline]
    fn pair(&self, base: u32, pair: u32) -> u32 {
        // Powers of two: the remainder wraps the ring and is the bounds check.
        let above = self.ring[base.wrapping_add(pair) as usize % WORDS];
        let below = self.ring[base.wrapping_add(pair >> 16) as usize % WORDS];
        above | below
    }
}

/// The low half: the offset, in the ring, of the word for (dx, +dy) from that of the present row;
/// the high half: that for (dx, -dy).
const fn offsets(dx: u32, dy: u32, stride: u32, words: u32) -> u32 {
    (dy * stride + dx) | ((words + dx - dy * stride) % words) << 16
}

/// The squared distance of a pair.
#[inline(always)]
fn squared<F: FieldCell>(pair: u32, stride: usize) -> F {
    let (dx, dy) = ((pair & 0xffff) % stride as u32, (pair & 0xffff) / stride as u32);
    F::new(dx * dx + dy * dy)
}

impl<F: FieldCell, const STRIDE: usize, const WORDS: usize> Kernel<F> for Bits<'_, STRIDE, WORDS> {
    const LANES: u32 = 32;

    fn all(&mut self, sources: Bitmap<'_>, field: &mut [F]) {
        let width = sources.width();
        for x0 in (0..width).step_by(32) {
            Kernel::<F>::start(self, x0 as i32);
            for (gy, row) in (0..).zip(field.chunks_exact_mut(width as usize)) {
                let x1 = width.min(x0 + 32) as usize;
                let row = row.get_mut(x0 as usize..x1).unwrap_or_default();
                self.row(sources, gy, (&Need::All, 0), row);
            }
        }
    }

    fn start(&mut self, x0: i32) {
        self.x0 = x0;
        self.next = i32::MIN;
        self.occupied = i32::MIN;
    }

    fn row(&mut self, sources: Bitmap<'_>, gy: i32, (need, least): (&Need<F>, u32), row: &mut [F]) -> u32 {
        let mask = need.mask(row);
        if mask == 0 {
            return 0;
        }
        let (first, last) = (gy - self.radius(), gy + self.radius());
        for entering in first.max(self.next)..last + 1 {
            self.enter(sources, entering);
        }
        self.next = last + 1;
        let base = Self::slot(gy) as u32;
        let mut rest = if self.occupied < first {
            0
        } else {
            mask & self.covered(base)
        };
        write(row, mask & !rest, F::NONE);
        if rest == 0 {
            return mask;
        }
        let first = FIRST.get(least as usize).copied().map_or(0, usize::from);
        let pairs = self.pairs.get(first..).unwrap_or_default();
        let (twos, last) = pairs.as_chunks();
        for &[one, two] in twos {
            // Most find nothing: looked at two at a time.
            let (in_one, in_two) = (self.pair(base, one) & rest, self.pair(base, two));
            if (in_one | in_two) & rest == 0 {
                continue;
            }
            write(row, in_one, squared(one, STRIDE));
            rest ^= in_one;
            write(row, in_two & rest, squared(two, STRIDE));
            rest &= !in_two;
            if rest == 0 {
                return mask;
            }
        }
        for &pair in last {
            write(row, self.pair(base, pair) & rest, squared(pair, STRIDE));
        }
        mask
    }
}

/// Writes `value` to the cells whose bits are set.
#[inline]
fn write<F: Copy>(row: &mut [F], mut cells: u32, value: F) {
    while cells != 0 {
        if let Some(cell) = row.get_mut(cells.trailing_zeros() as usize) {
            *cell = value;
        }
        cells &= cells - 1;
    }
}
