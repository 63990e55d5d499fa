use super::super::{BeamLimits, EvidenceU16, MassCell};

/// What a [`LocalMapping`](super::LocalMapping) stands on, borrowed. The contents do not matter; the
/// lengths are checked when it is made.
#[derive(Debug)]
pub struct MappingBuffers<'a, M: MassCell = EvidenceU16> {
    /// One cell of the fused map each.
    pub cells: &'a mut [M],
    /// [`class_bytes`](super::super::class_bytes) of the largest sensor lattice.
    pub classes: &'a mut [u8],
    /// One per beam of the largest scan.
    pub limits: &'a mut [BeamLimits],
    /// [`bitmap_words`](crate::storage::bitmap_words) of the fused map.
    pub binary: &'a mut [u32],
}

/// Storage for a [`LocalMapping`](super::LocalMapping) of `N` cells: one `static`.
///
/// `CLASSES` is [`class_bytes`](super::super::class_bytes) of the largest sensor lattice, `WORDS`
/// [`bitmap_words`](crate::storage::bitmap_words) of the map, `BEAMS` the beams of the largest scan.
#[derive(Clone, Debug)]
pub struct LocalMappingBuffers<
    const N: usize,
    const CLASSES: usize,
    const WORDS: usize,
    const BEAMS: usize,
    M: MassCell = EvidenceU16,
> {
    cells: [M; N],
    limits: [BeamLimits; BEAMS],
    binary: [u32; WORDS],
    classes: [u8; CLASSES],
}

impl<const N: usize, const CLASSES: usize, const WORDS: usize, const BEAMS: usize, M: MassCell>
    LocalMappingBuffers<N, CLASSES, WORDS, BEAMS, M>
{
    /// All bits zero: in a `static` it lies in `.bss` and costs no flash.
    pub const fn empty() -> Self {
        Self {
            cells: [M::VACUOUS; N],
            limits: [BeamLimits::EMPTY; BEAMS],
            binary: [0; WORDS],
            classes: [0; CLASSES],
        }
    }

    /// The buffers.
    pub fn split(&mut self) -> MappingBuffers<'_, M> {
        MappingBuffers {
            cells: &mut self.cells,
            classes: &mut self.classes,
            limits: &mut self.limits,
            binary: &mut self.binary,
        }
    }
}
