//! Recomputing the distance field from the source bits.
//!
//! Two kernels, equal to the bit: [`bits`] treats 32 cells as one word and is fastest on a core
//! without vector instructions; [`lanes`] treats 32 cells as bytes, which a compiler vectorises.

pub(crate) mod bits;
mod disc;
pub(crate) mod lanes;

pub(crate) use disc::Disc;

use super::field::FieldCell;
use crate::storage::Bitmap;

/// Recomputes cells of one strip of columns, row after row, top index last.
pub(crate) trait Kernel<F> {
    /// Columns that are treated at once, at most 32.
    const LANES: u32;

    /// Starts a strip whose first column is `x0`.
    fn start(&mut self, x0: i32);

    /// Writes the exact field value of the cells of row `gy` whose bits are set in `mask` to
    /// `row`, whose first cell is column `x0`. Rows come in ascending order.
    fn row(&mut self, sources: Bitmap<'_>, gy: i32, mask: u32, row: &mut [F]);
}

/// The kernel that is faster on this machine: vector units come with 64-bit cores.
pub(crate) const PREFER_LANES: bool = cfg!(target_pointer_width = "64");

/// `u32` words of scratch memory that recomputing a field of this radius takes.
///
/// 512 words up to 15 cells, 2048 up to 31, none beyond.
pub const fn scratch_words(radius_cells: u32) -> usize {
    match radius_cells {
        0..=15 => bits::NEAR_WORDS,
        16..=31 => bits::MIDDLE_WORDS,
        _ => 0,
    }
}

/// Runs `strip` with the right kernel for a disc.
pub(crate) fn with_kernel<F: FieldCell>(disc: &Disc, scratch: &mut [u32], job: impl Job<F>) {
    if disc.radius > 31 {
        #[cfg(target_pointer_width = "64")]
        return job.run(&mut lanes::Lanes::<F, 32, 512>::new(disc));
        #[cfg(not(target_pointer_width = "64"))]
        return job.run(&mut lanes::Lanes::<F, 1, 512>::new(disc));
    }
    if PREFER_LANES {
        if disc.radius <= 15 {
            job.run(&mut lanes::Lanes::<F, 32, 32>::new(disc));
        } else {
            job.run(&mut lanes::Lanes::<F, 32, 64>::new(disc));
        }
    } else if disc.radius <= 15 {
        if let Some(ring) = scratch.first_chunk_mut() {
            job.run(&mut bits::Near::new(disc, ring));
        }
    } else if F::MAX_RADIUS > 15
        && let Some(ring) = scratch.first_chunk_mut()
    {
        job.run(&mut bits::Middle::new(disc, ring));
    }
}

/// Work for whichever kernel is chosen.
pub(crate) trait Job<F> {
    fn run(self, kernel: &mut impl Kernel<F>);
}

/// The `n` lowest bits, 0 <= n <= 32.
#[inline]
pub(crate) fn low_bits(n: u32) -> u32 {
    if n >= 32 { u32::MAX } else { (1 << n) - 1 }
}
