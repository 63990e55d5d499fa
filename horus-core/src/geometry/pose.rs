use nalgebra::{Isometry2, Vector2};

/// Position in metres and heading in radians, counter-clockwise, in the frame its user names.
///
/// Plain fields, so that an all-zero one is the identity and costs no flash image in a `static`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(C)]
pub struct Pose2D {
    /// Metres along the frame's x axis.
    pub x: f32,
    /// Metres along the frame's y axis.
    pub y: f32,
    /// Heading in radians, counter-clockwise from the x axis.
    pub theta: f32,
}

impl Pose2D {
    /// A pose from metres and radians. Any values are accepted; users of a pose check them.
    pub const fn new(x: f32, y: f32, theta: f32) -> Self {
        Self { x, y, theta }
    }

    /// True if no coordinate is NaN or infinite.
    pub fn is_finite(&self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.theta.is_finite()
    }

    /// The same pose as a nalgebra isometry.
    pub fn isometry(&self) -> Isometry2<f32> {
        Isometry2::new(Vector2::new(self.x, self.y), self.theta)
    }
}
