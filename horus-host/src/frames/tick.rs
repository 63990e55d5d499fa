use std::sync::Arc;

use horus_core::prelude::Pose2D;

use super::StreamSession;
use crate::lockstep::Layers;

/// One tick of a stream.
#[derive(Debug, Clone, PartialEq)]
pub struct StreamedTick {
    /// The session it belongs to; the same `Arc` as long as that does not change.
    pub session: Arc<StreamSession>,
    /// Time of the scan, nanoseconds.
    pub stamp_ns: u64,
    /// The robot in the map's frame, metres and radians.
    pub robot: Pose2D,
    /// The lidar in the map's frame, metres and radians.
    pub sensor: Pose2D,
    /// Angle of the first beam, radians.
    pub angle_min: f32,
    /// Angle between beams, radians.
    pub angle_increment: f32,
    /// Shortest valid range, metres.
    pub range_min: f32,
    /// Longest valid range, metres.
    pub range_max: f32,
    /// Ranges in metres; none: the tick had no scan.
    pub ranges: Vec<f32>,
    /// The map after the tick, where the tick carried its changes.
    pub maps: Option<Layers>,
}
