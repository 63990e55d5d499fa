use super::{FrameKind, Payload, Put, Take};

/// Some ranges of a tick's scan, in order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScanPart<'a> {
    /// Index of the first beam.
    pub first: u32,
    /// Four bytes per range, the bits of its float.
    bytes: &'a [u8],
}

impl ScanPart<'_> {
    /// A part without ranges yet, from this beam on; they are appended to it.
    pub(super) fn starting_at(first: u32) -> Self {
        Self { first, bytes: &[] }
    }

    /// The ranges in metres.
    pub fn ranges(&self) -> impl ExactSizeIterator<Item = f32> + '_ {
        let (ranges, _) = self.bytes.as_chunks();
        ranges.iter().map(|bytes| f32::from_le_bytes(*bytes))
    }
}

impl<'a> Payload<'a> for ScanPart<'a> {
    const KIND: FrameKind = FrameKind::Scan;

    fn put(&self, out: &mut Put<'_>) {
        out.varint(self.first);
        out.bytes(self.bytes);
    }

    fn take(from: &mut Take<'a>) -> Option<Self> {
        let first = from.varint()?;
        let bytes = from.rest();
        bytes.len().is_multiple_of(4).then_some(Self { first, bytes })
    }
}
