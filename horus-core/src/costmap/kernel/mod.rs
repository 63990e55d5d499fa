//! Recomputing the distance field from the source bits.
//!
//! Four kernels, equal to the bit. On cores without vector instructions [`bits`] treats 32 cells as
//! one word, up to 31 cells of radius, and [`column`] serves larger radii; with the feature `dsp`,
//! `quads` treats four cells as one word where most of them are to be computed, up to 15 cells of
//! radius. On other cores [`lanes`] treats 32 cells as bytes, which a compiler vectorises.

pub(crate) mod bits;
pub(crate) mod column;
mod disc;
pub(crate) mod lanes;
mod need;
#[cfg(any(test, all(feature = "dsp", target_arch = "arm")))]
pub(crate) mod quads;
pub(crate) mod stamp;

pub(crate) use disc::Disc;
pub(crate) use need::{Lanes, Need};

use super::field::FieldCell;
use crate::storage::Bitmap;

/// Recomputes cells of one strip of columns, row after row, top index last.
pub(crate) trait Kernel<F> {
    /// Columns that are treated at once, at most 32.
    const LANES: u32;

    /// Computes the whole field, row-major.
    fn all(&mut self, sources: Bitmap<'_>, field: &mut [F]);

    /// Starts a strip whose first column is `x0`.
    fn start(&mut self, x0: i32);

    /// Writes the exact field value of the cells of `row` that need it; `row` has at most
    /// [`LANES`](Self::LANES) cells, starts at column `x0` of row `gy`, and rows come in ascending
    /// order. The `u32` beside the need is a number of cells: none that needs it is nearer to a
    /// source. Returns a bit per cell: set for all cells that needed it, perhaps for others.
    fn row(&mut self, sources: Bitmap<'_>, gy: i32, needed: (&Need<F>, u32), row: &mut [F]) -> u32;
}

/// The kernel that is faster on this machine: vector units come with 64-bit cores. A build with
/// `--cfg horus_bits_kernel` tests the other one there.
pub(crate) const PREFER_LANES: bool = cfg!(all(target_pointer_width = "64", not(horus_bits_kernel)));

/// `u32` words of scratch memory that recomputing a field of this radius takes.
///
/// 512 words up to 15 cells, 2048 up to 31, 512 beyond: 2048 words serve every radius.
pub const fn scratch_words(radius_cells: u32) -> usize {
    match radius_cells {
        0..=15 => bits::NEAR_WORDS,
        16..=31 => bits::MIDDLE_WORDS,
        _ => column::FAR_WORDS,
    }
}

/// Computes the whole field of a disc from its sources.
pub(crate) fn compute<F: FieldCell>(disc: &Disc, scratch: &mut [u32], sources: Bitmap<'_>, field: &mut [F]) {
    struct All<'b, F> {
        sources: Bitmap<'b>,
        field: &'b mut [F],
    }
    impl<F> Job<F> for All<'_, F> {
        fn is_dense(&self) -> bool {
            true
        }

        fn run(self, kernel: &mut impl Kernel<F>) {
            kernel.all(self.sources, self.field);
        }
    }
    // Wider strips read fewer rows twice; masks for single cells have no room for them.
    if PREFER_LANES && disc.radius <= 15 {
        lanes::Lanes::<F, 64, 32>::new(disc).all(sources, field);
    } else {
        with_kernel(disc, scratch, All { sources, field });
    }
}

/// Runs a job with the right kernel for a disc.
pub(crate) fn with_kernel<F: FieldCell>(disc: &Disc, scratch: &mut [u32], job: impl Job<F>) {
    if F::MAX_RADIUS > 31 && disc.radius > 31 {
        far(disc, scratch, job);
        return;
    }
    if PREFER_LANES {
        if disc.radius <= 15 {
            job.run(&mut lanes::Lanes::<F, 32, 32>::new(disc));
        } else {
            job.run(&mut lanes::Lanes::<F, 32, 64>::new(disc));
        }
    } else if disc.radius <= 15 {
        if let Some(ring) = scratch.first_chunk_mut() {
            near(disc, ring, job);
        }
    } else if F::MAX_RADIUS > 15
        && let Some(ring) = scratch.first_chunk_mut()
    {
        job.run(&mut bits::Middle::new(disc, ring));
    }
}

/// The kernel for radii up to 15 cells.
#[cfg(not(all(feature = "dsp", target_arch = "arm")))]
fn near<F: FieldCell>(disc: &Disc, scratch: &mut [u32; bits::NEAR_WORDS], job: impl Job<F>) {
    job.run(&mut bits::Near::new(disc, scratch));
}

/// The kernel for radii up to 15 cells.
#[cfg(all(feature = "dsp", target_arch = "arm"))]
fn near<F: FieldCell>(disc: &Disc, scratch: &mut [u32; bits::NEAR_WORDS], job: impl Job<F>) {
    if job.is_dense() {
        if let Some(mut kernel) = quads::Quads::new(disc, scratch) {
            job.run(&mut kernel);
        }
    } else {
        job.run(&mut bits::Near::new(disc, scratch));
    }
}

/// The kernel for radii above 31 cells, in a frame of its own: where vectors are preferred its ring
/// takes 32 KiB of stack.
#[inline(never)]
fn far<F: FieldCell>(disc: &Disc, scratch: &mut [u32], job: impl Job<F>) {
    if PREFER_LANES {
        job.run(&mut lanes::Lanes::<F, 32, 512>::new(disc));
    } else if let Some(ring) = scratch.first_chunk_mut() {
        job.run(&mut column::Column::new(disc, ring));
    }
}

/// Work for whichever kernel is chosen.
pub(crate) trait Job<F> {
    /// True if most cells are to be recomputed, not a few of each row.
    #[cfg_attr(not(all(feature = "dsp", target_arch = "arm")), expect(dead_code))]
    fn is_dense(&self) -> bool;
    fn run(self, kernel: &mut impl Kernel<F>);
}

/// The `n` lowest bits, 0 <= n <= 32.
#[inline]
pub(crate) fn low_bits(n: u32) -> u32 {
    if n >= 32 { u32::MAX } else { (1 << n) - 1 }
}
