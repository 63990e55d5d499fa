use arbitrary::Arbitrary;
use horus_core::frames::{FrameHeader, SYNC};

/// A frame that only its contents can make wrong.
#[derive(Clone, Debug, Arbitrary)]
pub struct SoundFrame {
    kind: u8,
    /// 0: the number follows that of the frame before.
    jump: u8,
    payload: Vec<u8>,
}

impl SoundFrame {
    /// The sequence number of the frame after it.
    pub fn next(&self, sequence: u32) -> u32 {
        sequence.wrapping_add(1 + u32::from(self.jump))
    }

    /// The frame's bytes.
    pub fn bytes(&self, sequence: u32) -> Vec<u8> {
        let payload = &self.payload[..self.payload.len().min(2000)];
        let mut covered = vec![1, self.kind % 8];
        covered.extend(sequence.to_le_bytes());
        covered.extend((payload.len() as u16).to_le_bytes());
        covered.extend(payload);
        let crc = crc32fast::hash(&covered);
        let frame = [&SYNC[..], &covered, &crc.to_le_bytes()].concat();
        assert_eq!(frame.len(), FrameHeader::OVERHEAD + payload.len());
        frame
    }
}
