/// A position and heading in the plane.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Pose2D {
    /// Metres along the parent frame's x axis.
    pub x: f64,
    /// Metres along the parent frame's y axis.
    pub y: f64,
    /// Heading in radians, counter-clockwise from the x axis.
    pub theta: f64,
}

impl Pose2D {
    /// A pose at (`x`, `y`) metres with heading `theta` radians.
    pub const fn new(x: f64, y: f64, theta: f64) -> Self {
        Self { x, y, theta }
    }

    /// x, y and heading rounded to f32, or `None` if one of them is not finite there.
    pub(super) fn to_f32(self) -> Option<[f32; 3]> {
        let pose = [self.x as f32, self.y as f32, self.theta as f32];
        pose.iter().all(|v| v.is_finite()).then_some(pose)
    }
}
