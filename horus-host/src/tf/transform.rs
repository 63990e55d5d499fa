//! Transforms in space, as a log carries them.

use nalgebra::{Isometry3, Quaternion, Translation3, Unit, UnitQuaternion};

use super::Pose2;

/// A quaternion whose largest component is smaller than this has no usable direction.
const SMALLEST_QUATERNION: f64 = 1e-6;

/// The pose of a child frame in its parent frame, laid out as in `geometry_msgs/msg/Transform`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transform {
    /// Position x, y, z in metres.
    pub translation: [f64; 3],
    /// Rotation as a quaternion x, y, z, w. It need not be of unit length; see
    /// [`TfBuffer::insert`](super::TfBuffer::insert).
    pub rotation: [f64; 4],
}

impl Transform {
    /// The transform that changes nothing.
    pub const IDENTITY: Self = Self {
        translation: [0.0; 3],
        rotation: [0.0, 0.0, 0.0, 1.0],
    };

    /// A transform within the plane z = 0: metres, and radians about z.
    pub fn planar(x: f64, y: f64, yaw: f64) -> Self {
        let (sin, cos) = libm::sincos(yaw * 0.5);
        Self {
            translation: [x, y, 0.0],
            rotation: [0.0, 0.0, sin, cos],
        }
    }

    /// The transform as seen from above: x, y, and the direction of its x axis in the plane.
    ///
    /// Height, roll and pitch are dropped. The yaw is 0 where the x axis points straight up or
    /// down and therefore has no direction in the plane.
    pub fn to_planar(&self) -> Pose2 {
        let [x, y, z, w] = self.rotation;
        let forward_x = w * w + x * x - y * y - z * z;
        let forward_y = 2.0 * (x * y + w * z);
        let vertical = libm::hypot(forward_x, forward_y) < 1e-9;
        Pose2 {
            x: self.translation[0],
            y: self.translation[1],
            yaw: if vertical {
                0.0
            } else {
                libm::atan2(forward_y, forward_x)
            },
        }
    }

    /// True if all seven numbers are finite.
    pub(super) fn is_finite(&self) -> bool {
        let all = self.translation.iter().chain(&self.rotation);
        all.copied().all(f64::is_finite)
    }

    /// The same transform with a unit quaternion; `None` if the quaternion is (nearly) zero.
    pub(super) fn to_isometry(self) -> Option<Isometry3<f64>> {
        let [x, y, z, w] = self.rotation;
        let largest = x.abs().max(y.abs()).max(z.abs()).max(w.abs());
        if largest < SMALLEST_QUATERNION {
            return None;
        }
        // Scaling first keeps the squares of huge components finite.
        let scaled = Quaternion::new(w / largest, x / largest, y / largest, z / largest);
        let [x, y, z] = self.translation;
        Some(Isometry3::from_parts(
            Translation3::new(x, y, z),
            Unit::new_normalize(scaled),
        ))
    }

    /// Takes the numbers out of an isometry.
    pub(super) fn from_isometry(isometry: &Isometry3<f64>) -> Self {
        let t = &isometry.translation;
        let q: &UnitQuaternion<f64> = &isometry.rotation;
        Self {
            translation: [t.x, t.y, t.z],
            rotation: [q.i, q.j, q.k, q.w],
        }
    }
}
