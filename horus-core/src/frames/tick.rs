use super::{FrameKind, Payload, Put, Take};
use crate::geometry::Pose2D;

/// The start of a tick: when and where, and the geometry of its scan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TickStart {
    /// The tick carries the whole map: a listener may start with it.
    pub is_key: bool,
    /// The tick carries the map's changes since the last one that did.
    pub has_maps: bool,
    /// Time of the scan, nanoseconds since the epoch its user keeps.
    pub stamp_ns: u64,
    /// The robot in the map's frame, metres and radians.
    pub robot: Pose2D,
    /// The lidar in the map's frame, metres and radians.
    pub sensor: Pose2D,
    /// Whole cells the window has moved since construction, along x and y.
    pub offset: [i32; 2],
    /// Beams of the scan; 0: there was none.
    pub beams: u32,
    /// Angle of the first beam, radians.
    pub angle_min: f32,
    /// Angle between beams, radians.
    pub angle_increment: f32,
    /// Shortest valid range, metres.
    pub range_min: f32,
    /// Longest valid range, metres.
    pub range_max: f32,
}

const KEY: u8 = 1;
const MAPS: u8 = 2;

impl Payload<'_> for TickStart {
    const KIND: FrameKind = FrameKind::TickStart;

    fn put(&self, out: &mut Put<'_>) {
        let flag = |on, bit| if on { bit } else { 0 };
        out.u8(flag(self.is_key, KEY) | flag(self.has_maps, MAPS));
        out.u64(self.stamp_ns);
        out.pose(self.robot);
        out.pose(self.sensor);
        self.offset.into_iter().for_each(|cells| out.u32(cells as u32));
        out.varint(self.beams);
        out.f32(self.angle_min);
        out.f32(self.angle_increment);
        out.f32(self.range_min);
        out.f32(self.range_max);
    }

    fn take(from: &mut Take<'_>) -> Option<Self> {
        let flags = from.u8()?;
        if flags & !(KEY | MAPS) != 0 {
            return None;
        }
        Some(Self {
            is_key: flags & KEY != 0,
            has_maps: flags & MAPS != 0,
            stamp_ns: from.u64()?,
            robot: from.pose()?,
            sensor: from.pose()?,
            offset: [from.u32()? as i32, from.u32()? as i32],
            beams: from.varint()?,
            angle_min: from.f32()?,
            angle_increment: from.f32()?,
            range_min: from.f32()?,
            range_max: from.f32()?,
        })
    }
}
