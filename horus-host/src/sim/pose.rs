//! Planar poses.

/// A pose in the plane: metres and radians, counter-clockwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Position along x, in metres.
    pub x: f64,
    /// Position along y, in metres.
    pub y: f64,
    /// Heading in radians.
    pub theta: f64,
}

impl Pose {
    /// The pose of something mounted at `mount` on a body at this pose.
    pub fn mounted(&self, mount: &Self) -> Self {
        let (sin, cos) = libm::sincos(self.theta);
        Self {
            x: self.x + (cos * mount.x - sin * mount.y),
            y: self.y + (sin * mount.x + cos * mount.y),
            theta: self.theta + mount.theta,
        }
    }
}
