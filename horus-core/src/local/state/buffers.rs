use super::{BufferSlot, SensingState};

/// Storage for a [`SensingState`]: `SLOTS` names, `FLOATS` and `BYTES` elements for all buffers
/// together.
#[derive(Clone, Debug)]
pub struct SensingBuffers<const SLOTS: usize, const FLOATS: usize, const BYTES: usize> {
    slots: [BufferSlot; SLOTS],
    floats: [f32; FLOATS],
    bytes: [u8; BYTES],
}

impl<const SLOTS: usize, const FLOATS: usize, const BYTES: usize> SensingBuffers<SLOTS, FLOATS, BYTES> {
    /// All bits zero: costs no flash image in a `static`.
    pub const fn empty() -> Self {
        Self {
            slots: [BufferSlot::EMPTY; SLOTS],
            floats: [0.0; FLOATS],
            bytes: [0; BYTES],
        }
    }

    /// A state without buffers over this storage.
    pub fn state(&mut self) -> SensingState<'_> {
        SensingState::new_in(&mut self.slots, &mut self.floats, &mut self.bytes)
    }
}
