use super::crc::Crc32;
use super::{FrameHeader, FrameKind, MAX_FRAME, Put, SYNC, VERSION};

/// Builds one frame after the other in the same buffer.
#[derive(Debug)]
pub(super) struct Packer<'b> {
    buffer: &'b mut [u8],
    /// Bytes of the present frame, its prefix included.
    len: usize,
    kind: u8,
    sequence: u32,
}

impl<'b> Packer<'b> {
    /// The buffer holds [`MIN_BUFFER`](super::MIN_BUFFER) bytes or more.
    pub fn new(buffer: &'b mut [u8]) -> Self {
        let usable = buffer.len().min(MAX_FRAME);
        Self {
            buffer: buffer.get_mut(..usable).unwrap_or_default(),
            len: FrameHeader::PREFIX,
            kind: 0,
            sequence: 0,
        }
    }

    /// Sequence number of the next frame.
    pub fn sequence(&self) -> u32 {
        self.sequence
    }

    /// Starts a frame over.
    pub fn begin(&mut self, kind: FrameKind) {
        self.kind = kind as u8;
        self.len = FrameHeader::PREFIX;
    }

    /// Bytes that the payload may still grow by.
    #[inline]
    pub fn room(&self) -> usize {
        self.buffer.len().saturating_sub(self.len + FrameHeader::CRC_LEN)
    }

    /// Where the next byte goes.
    pub fn position(&self) -> usize {
        self.len
    }

    /// Appends fields to the payload.
    pub fn put(&mut self, write: impl FnOnce(&mut Put<'_>)) {
        let mut out = Put::new(self.buffer, self.len);
        write(&mut out);
        self.len = out.len();
    }

    /// Changes a byte of the payload.
    pub fn set(&mut self, position: usize, value: u8) {
        if let Some(byte) = self.buffer.get_mut(position) {
            *byte = value;
        }
    }

    /// Completes the frame.
    pub fn finish(&mut self) -> &[u8] {
        let header = FrameHeader {
            version: VERSION,
            kind: self.kind,
            sequence: self.sequence,
            payload_len: (self.len - FrameHeader::PREFIX) as u16, // at most MAX_FRAME
        };
        self.sequence = self.sequence.wrapping_add(1);
        let mut out = Put::new(self.buffer, 0);
        out.bytes(&SYNC);
        header.put(&mut out);
        let covered = self.buffer.get(SYNC.len()..self.len).unwrap_or_default();
        let crc = Crc32::of(covered.iter().copied());
        self.put(|out| out.u32(crc));
        self.buffer.get(..self.len).unwrap_or_default()
    }
}
