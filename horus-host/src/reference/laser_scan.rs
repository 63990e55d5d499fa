use super::ReferenceError;

/// One sweep of a planar range sensor, with the range conventions of REP 117: +inf is no return within
/// `range_max`, -inf is too close, NaN is invalid.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LaserScan {
    /// Direction of beam 0 in the sensor's frame, radians counter-clockwise from its x axis.
    pub angle_min: f32,
    /// Radians from one beam to the next.
    pub angle_increment: f32,
    /// Shortest valid range in metres.
    pub range_min: f32,
    /// Longest valid range in metres: from here on a beam has hit nothing.
    pub range_max: f32,
    /// Measured ranges in metres, one per beam.
    pub ranges: Vec<f32>,
}

/// What a range says: how far its beam reaches, and whether something was there.
pub(super) enum Beam {
    Hit(f32),
    Miss(f32),
    Ignored,
}

impl LaserScan {
    pub(super) fn validate(&self) -> Result<(), ReferenceError> {
        let fields = [
            ("angle_min", self.angle_min.is_finite()),
            ("angle_increment", self.angle_increment.is_finite()),
            ("range_min", !self.range_min.is_nan()),
            ("range_max", !self.range_max.is_nan()),
        ];
        match fields.iter().find(|(_, valid)| !valid) {
            Some((name, _)) => Err(ReferenceError::Scan(name)),
            None => Ok(()),
        }
    }

    /// Unit vector of beam `i` in the sensor's frame: computed in f64, then rounded once.
    pub(super) fn direction(&self, i: usize) -> [f32; 2] {
        let angle = f64::from(self.angle_min) + i as f64 * f64::from(self.angle_increment);
        [libm::cos(angle) as f32, libm::sin(angle) as f32]
    }

    pub(super) fn beam(&self, range: f32) -> Beam {
        if range.is_nan() || range == f32::NEG_INFINITY || range < self.range_min {
            Beam::Ignored
        } else if range >= self.range_max || range == f32::INFINITY {
            Beam::Miss(self.range_max)
        } else {
            Beam::Hit(range)
        }
    }
}
