use super::{Put, Take};

/// The first bytes of every frame. Neither occurs in UTF-8.
pub const SYNC: [u8; 2] = [0xc1, 0xfa];

/// Version of the format described in the [module](super)'s documentation.
pub const VERSION: u8 = 1;

/// What stands between sync word and payload.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameHeader {
    /// Version of the format.
    pub version: u8,
    /// A [`FrameKind`](super::FrameKind), maybe one this version does not know.
    pub kind: u8,
    /// One more than that of the frame before, wrapping.
    pub sequence: u32,
    /// Bytes of payload.
    pub payload_len: u16,
}

impl FrameHeader {
    /// Bytes of a header, the sync word not counted.
    pub const LEN: usize = 8;
    /// Bytes of the CRC after the payload.
    pub const CRC_LEN: usize = 4;
    /// Bytes of a frame beside its payload: sync word, header and CRC.
    pub const OVERHEAD: usize = SYNC.len() + Self::LEN + Self::CRC_LEN;
    /// Bytes in front of the payload.
    pub(super) const PREFIX: usize = SYNC.len() + Self::LEN;

    /// Appends the header.
    pub fn put(&self, out: &mut Put<'_>) {
        out.u8(self.version);
        out.u8(self.kind);
        out.u32(self.sequence);
        out.u16(self.payload_len);
    }

    /// Reads a header.
    pub fn take(from: &mut Take<'_>) -> Option<Self> {
        Some(Self {
            version: from.u8()?,
            kind: from.u8()?,
            sequence: from.u32()?,
            payload_len: from.u16()?,
        })
    }

    /// Bytes of the whole frame.
    pub fn frame_len(&self) -> usize {
        Self::OVERHEAD + usize::from(self.payload_len)
    }
}
