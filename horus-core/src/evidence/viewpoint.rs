use crate::geometry::Pose2D;
use crate::math;

/// A pose from which points of its parent frame are seen: f32, one order of operations.
#[derive(Clone, Copy, Debug)]
pub(super) struct Viewpoint {
    x: f32,
    y: f32,
    cos: f32,
    sin: f32,
}

impl Viewpoint {
    pub(super) fn new(pose: Pose2D) -> Self {
        let (cos, sin) = math::cos_sin(pose.theta);
        Self {
            x: pose.x,
            y: pose.y,
            cos,
            sin,
        }
    }

    /// A point of the parent frame in the pose's own.
    #[inline]
    pub(super) fn see(&self, (x, y): (f32, f32)) -> (f32, f32) {
        let (dx, dy) = (x - self.x, y - self.y);
        (self.cos * dx + self.sin * dy, self.cos * dy - self.sin * dx)
    }

    /// A point of the pose's own frame in the parent frame.
    pub(super) fn point(&self, (x, y): (f32, f32)) -> (f32, f32) {
        (
            self.x + (self.cos * x - self.sin * y),
            self.y + (self.sin * x + self.cos * y),
        )
    }
}
