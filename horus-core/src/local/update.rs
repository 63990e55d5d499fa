use crate::geometry::Pose2D;

/// What an update of a local map did.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LocalUpdate {
    /// Whole cells the window moved along x and y.
    pub shift: [i32; 2],
    /// The robot's pose in the map's frame that was used.
    pub pose: Pose2D,
    /// Where the pose came from.
    pub source: PoseSource,
    /// Odometry sensors that are configured but were not in the state.
    pub missing_odometries: u32,
    /// Lidars whose scans were drawn.
    pub lidars: u32,
    /// Lidars that are configured but were not in the state.
    pub missing_lidars: u32,
    /// Lidars whose scans had no ranges.
    pub empty_lidars: u32,
    /// Lidars whose angles, mounting pose or longest range were not usable numbers.
    pub invalid_lidars: u32,
    /// Beams that marked a cell of the map.
    pub marks: u32,
    /// Beams that were NaN or -inf.
    pub ignored: u32,
}

/// Where the pose of an update came from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum PoseSource {
    /// The map's own odometry sensor.
    Odometry,
    /// The external odometry sensor.
    ExternalOdometry,
    /// The pose given to the update.
    Given,
}
