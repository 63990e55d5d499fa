use horus_core::costmap::{CostMapBuffers, FieldCell};
use horus_core::distance::{DistanceCell, DistanceMapBuffers};
use horus_core::evidence::{EvidenceF32, EvidenceU8, EvidenceU16, LocalMappingBuffers, MassCell};
use horus_core::local::SensingBuffers;
use horus_core::prelude::ScanBuffers;

/// Memory in which one object after another is made, so that programs for 128 KiB of RAM can have
/// several large ones.
#[derive(Debug)]
#[repr(C, align(8))]
pub struct Arena<const BYTES: usize>([u8; BYTES]);

/// Types for which all bits zero is a value.
///
/// # Safety
/// It must be.
pub unsafe trait ZeroBits {}

// SAFETY: integers, and tables whose documented empty value is all bits zero.
unsafe impl<const N: usize, const WORDS: usize, F: FieldCell, const SCRATCH: usize> ZeroBits
    for CostMapBuffers<N, WORDS, F, SCRATCH>
{
}
// SAFETY: integers.
unsafe impl<D: DistanceCell, const N: usize, const VERTICES: usize> ZeroBits
    for DistanceMapBuffers<D, N, VERTICES>
{
}
// SAFETY: numbers.
unsafe impl<const BEAMS: usize, const WORDS: usize> ZeroBits for ScanBuffers<BEAMS, WORDS> {}
// SAFETY: numbers, and an enum whose first value is zero.
unsafe impl<const SLOTS: usize, const FLOATS: usize, const BYTES: usize> ZeroBits
    for SensingBuffers<SLOTS, FLOATS, BYTES>
{
}
// SAFETY: mass cells, whose vacuous state is all bits zero, and numbers.
unsafe impl<
    const N: usize,
    const CLASSES: usize,
    const WORDS: usize,
    const BEAMS: usize,
    const VERTICES: usize,
    M: MassCell,
    D: DistanceCell,
> ZeroBits for LocalMappingBuffers<N, CLASSES, WORDS, BEAMS, VERTICES, M, D>
{
}
// SAFETY: as above.
unsafe impl<const N: usize> ZeroBits for [EvidenceU16; N] {}
// SAFETY: as above.
unsafe impl<const N: usize> ZeroBits for [EvidenceU8; N] {}
// SAFETY: as above.
unsafe impl<const N: usize> ZeroBits for [EvidenceF32; N] {}
// SAFETY: numbers.
unsafe impl<const N: usize> ZeroBits for [[f64; 3]; N] {}
// SAFETY: bytes.
unsafe impl<const N: usize> ZeroBits for [u8; N] {}
// SAFETY: as above.
unsafe impl<const N: usize> ZeroBits for [f32; N] {}
// SAFETY: bytes.
unsafe impl<const N: usize> ZeroBits for [i8; N] {}
// SAFETY: both are, and padding may be anything.
unsafe impl<A: ZeroBits, B: ZeroBits> ZeroBits for (A, B) {}

impl<const BYTES: usize> Arena<BYTES> {
    /// All bits zero.
    #[allow(clippy::new_without_default, clippy::large_stack_arrays)]
    pub const fn new() -> Self {
        Self([0; BYTES])
    }

    /// An object of all bits zero; the previous one's borrow has ended.
    pub fn zeroed<T: ZeroBits>(&mut self) -> &mut T {
        const { assert!(size_of::<T>() <= BYTES && align_of::<T>() <= 8) };
        let start = (&raw mut self.0).cast::<T>();
        // SAFETY: in bounds and aligned, checked above; zero bits are a value of T; the borrow is
        // that of the whole arena, and T has nothing to drop that owns anything.
        unsafe {
            start.write_bytes(0, 1);
            &mut *start
        }
    }
}
