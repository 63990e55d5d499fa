use crate::geometry::{GridInfo, Pose2D};
use crate::math;

/// A rotation and translation in f64: a handful per scan, so that what follows from them is exact far
/// from the origin, too.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rigid {
    cos: f64,
    sin: f64,
    x: f64,
    y: f64,
}

impl Rigid {
    pub(crate) fn apply(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [
            self.cos * x - self.sin * y + self.x,
            self.sin * x + self.cos * y + self.y,
        ]
    }

    /// (cos, sin) of the rotation.
    pub(crate) fn direction(&self) -> [f64; 2] {
        [self.cos, self.sin]
    }

    pub(crate) fn inverse(&self) -> Self {
        Self {
            cos: self.cos,
            sin: -self.sin,
            x: -(self.cos * self.x + self.sin * self.y),
            y: self.sin * self.x - self.cos * self.y,
        }
    }

    /// `other` first, then `self`.
    pub(crate) fn after(&self, other: &Self) -> Self {
        let [x, y] = self.apply([other.x, other.y]);
        Self {
            cos: self.cos * other.cos - self.sin * other.sin,
            sin: self.sin * other.cos + self.cos * other.sin,
            x,
            y,
        }
    }
}

impl From<Pose2D> for Rigid {
    fn from(pose: Pose2D) -> Self {
        let (cos, sin) = math::cos_sin_f64(f64::from(pose.theta));
        Self {
            cos,
            sin,
            x: f64::from(pose.x),
            y: f64::from(pose.y),
        }
    }
}

/// From metres along a grid's axes, counted from the corner of its window, to the grid's frame.
pub(crate) fn frame_from_window(info: &GridInfo) -> Rigid {
    let metres = info
        .offset()
        .map(|cells| f64::from(cells) * f64::from(info.resolution()));
    let first = Rigid::from(info.first_origin());
    let [x, y] = first.apply(metres);
    Rigid { x, y, ..first }
}
