use super::super::{Pose2D, ReferenceError};

/// The scan of a lidar whose beams are spread evenly over its field of view.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LidarScan {
    /// Where the lidar sits on the robot.
    pub mount: Pose2D,
    /// Angle of the first beam, radians counter-clockwise from the sensor's x axis.
    pub start_angle: f32,
    /// Angle between the first and the last beam in radians.
    pub fov: f32,
    /// Longest range in metres.
    pub max_range: f32,
    /// Ranges in metres: +inf is a miss, NaN and -inf say nothing.
    pub ranges: Vec<f32>,
}

impl LidarScan {
    /// Checks the numbers.
    ///
    /// # Errors
    /// A mounting pose or an angle that is not finite, a longest range that is not finite or negative.
    pub fn validate(&self) -> Result<(), ReferenceError> {
        self.mount.to_f32().ok_or(ReferenceError::Pose("mounting pose"))?;
        let fields = [
            ("start_angle", self.start_angle.is_finite()),
            ("fov", self.fov.is_finite()),
            ("max_range", self.max_range.is_finite() && self.max_range >= 0.0),
        ];
        match fields.iter().find(|(_, valid)| !valid) {
            Some((name, _)) => Err(ReferenceError::Scan(name)),
            None => Ok(()),
        }
    }

    /// Unit vector of beam `i` in the sensor's frame: computed in f64, then rounded once.
    pub(super) fn direction(&self, i: usize) -> [f32; 2] {
        let gaps = self.ranges.len().max(2) - 1;
        let angle = f64::from(self.start_angle) + i as f64 * f64::from(self.fov) / gaps as f64;
        [libm::cos(angle) as f32, libm::sin(angle) as f32]
    }
}
