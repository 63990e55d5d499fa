use super::{DistanceCell, EnvelopeVertex};

/// The memory of a [`DistanceMap`](super::DistanceMap), all of it the caller's.
#[derive(Debug)]
pub struct DistanceBuffers<'a, D> {
    /// One per cell; for a window one per cell of its [region](super::DistanceMap::region).
    pub cells: &'a mut [D],
    /// One per column, two for a signed map.
    pub vertices: &'a mut [EnvelopeVertex],
}

/// Storage for a map of up to `N` cells, with `VERTICES` = its columns, twice them if `D` is signed.
///
/// All bits zero: as a `static` it lies in `.bss`.
///
/// ```
/// use horus_core::distance::{DistanceMap, DistanceMapBuffers};
///
/// let mut storage = DistanceMapBuffers::<u16, { 200 * 200 }, 200>::empty();
/// let map = DistanceMap::new_in(storage.split());
/// assert!(map.squared().is_empty());
/// ```
#[derive(Clone, Debug)]
pub struct DistanceMapBuffers<D, const N: usize, const VERTICES: usize> {
    cells: [D; N],
    vertices: [EnvelopeVertex; VERTICES],
}

macro_rules! empty {
    ($($cell:ty)*) => { $(
        impl<const N: usize, const VERTICES: usize> DistanceMapBuffers<$cell, N, VERTICES> {
            /// All bits zero.
            pub const fn empty() -> Self {
                Self {
                    cells: [0; N],
                    vertices: [EnvelopeVertex::EMPTY; VERTICES],
                }
            }
        }
    )* };
}

empty!(u16 u32 i16 i32);

impl<D: DistanceCell, const N: usize, const VERTICES: usize> DistanceMapBuffers<D, N, VERTICES> {
    /// Borrows the parts.
    pub fn split(&mut self) -> DistanceBuffers<'_, D> {
        DistanceBuffers {
            cells: &mut self.cells,
            vertices: &mut self.vertices,
        }
    }
}
