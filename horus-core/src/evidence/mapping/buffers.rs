use super::super::{BeamLimits, EvidenceU16, MassCell};
use crate::distance::{DistanceBuffers, DistanceCell, DistanceMapBuffers};

/// What a [`LocalMapping`](super::LocalMapping) stands on, borrowed. The contents do not matter; the
/// lengths are checked when it is made.
#[derive(Debug)]
pub struct MappingBuffers<'a, M: MassCell = EvidenceU16, D: DistanceCell = u16> {
    /// One cell of the fused map each.
    pub cells: &'a mut [M],
    /// [`class_bytes`](super::super::class_bytes) of the largest sensor lattice.
    pub classes: &'a mut [u8],
    /// One per beam of the largest scan.
    pub limits: &'a mut [BeamLimits],
    /// [`bitmap_words`](crate::storage::bitmap_words) of the fused map.
    pub binary: &'a mut [u32],
    /// Of the fused map.
    pub distance: DistanceBuffers<'a, D>,
}

/// Storage for a [`LocalMapping`](super::LocalMapping) of `N` cells: one `static`.
///
/// `CLASSES` is [`class_bytes`](super::super::class_bytes) of the largest sensor lattice, `WORDS`
/// [`bitmap_words`](crate::storage::bitmap_words) of the map, `BEAMS` the beams of the largest scan,
/// `VERTICES` the map's columns (its lattice's rows), twice them if `D` is signed.
///
/// 128 x 128 cells of two 16-bit masses with 360 beams take 109 188 bytes.
#[derive(Clone, Debug)]
pub struct LocalMappingBuffers<
    const N: usize,
    const CLASSES: usize,
    const WORDS: usize,
    const BEAMS: usize,
    const VERTICES: usize,
    M: MassCell = EvidenceU16,
    D: DistanceCell = u16,
> {
    cells: [M; N],
    distance: DistanceMapBuffers<D, N, VERTICES>,
    limits: [BeamLimits; BEAMS],
    binary: [u32; WORDS],
    classes: [u8; CLASSES],
}

macro_rules! empty {
    ($($distance:ty)*) => { $(
        impl<
            const N: usize,
            const CLASSES: usize,
            const WORDS: usize,
            const BEAMS: usize,
            const VERTICES: usize,
            M: MassCell,
        > LocalMappingBuffers<N, CLASSES, WORDS, BEAMS, VERTICES, M, $distance>
        {
            /// All bits zero: in a `static` it lies in `.bss` and costs no flash.
            pub const fn empty() -> Self {
                Self {
                    cells: [M::VACUOUS; N],
                    distance: DistanceMapBuffers::<$distance, N, VERTICES>::empty(),
                    limits: [BeamLimits::EMPTY; BEAMS],
                    binary: [0; WORDS],
                    classes: [0; CLASSES],
                }
            }
        }
    )* };
}

empty!(u16 u32 i16 i32);

impl<
    const N: usize,
    const CLASSES: usize,
    const WORDS: usize,
    const BEAMS: usize,
    const VERTICES: usize,
    M: MassCell,
    D: DistanceCell,
> LocalMappingBuffers<N, CLASSES, WORDS, BEAMS, VERTICES, M, D>
{
    /// The buffers.
    pub fn split(&mut self) -> MappingBuffers<'_, M, D> {
        MappingBuffers {
            cells: &mut self.cells,
            classes: &mut self.classes,
            limits: &mut self.limits,
            binary: &mut self.binary,
            distance: self.distance.split(),
        }
    }
}
