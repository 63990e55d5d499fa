use super::{FrameKind, Payload, Put, Take};

/// The end of a tick.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TickEnd {
    /// Checksum of the whole map after the tick, where one was asked for.
    pub checksum: Option<MapChecksum>,
}

/// CRC-32 of every cell, row-major, of both maps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MapChecksum {
    /// Of the occupancy values as bytes.
    pub occupancy: u32,
    /// Of the costs.
    pub costs: u32,
}

impl Payload<'_> for TickEnd {
    const KIND: FrameKind = FrameKind::TickEnd;

    fn put(&self, out: &mut Put<'_>) {
        out.u8(u8::from(self.checksum.is_some()));
        if let Some(checksum) = self.checksum {
            out.u32(checksum.occupancy);
            out.u32(checksum.costs);
        }
    }

    fn take(from: &mut Take<'_>) -> Option<Self> {
        let checksum = match from.flag()? {
            false => None,
            true => Some(MapChecksum {
                occupancy: from.u32()?,
                costs: from.u32()?,
            }),
        };
        Some(Self { checksum })
    }
}
