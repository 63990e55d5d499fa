//! What one moment of a simulation yields.

use super::Pose;

/// One scan and where it was taken.
#[derive(Debug, Clone, PartialEq)]
pub struct SimTick {
    /// Time in nanoseconds.
    pub stamp_ns: u64,
    /// The robot's true pose in the world, which is also its odometry.
    pub robot: Pose,
    /// One range per beam, in metres, in the terms of REP-117: +inf nothing within range, -inf too
    /// close, NaN invalid.
    pub ranges: Vec<f32>,
}
