//! Planar poses.

/// A pose in the plane: metres and radians, counter-clockwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose2 {
    /// Position along x, in metres.
    pub x: f64,
    /// Position along y, in metres.
    pub y: f64,
    /// Heading in radians, in -pi..=pi.
    pub yaw: f64,
}
