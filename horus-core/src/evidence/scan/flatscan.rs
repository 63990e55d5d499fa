use core::f32::consts::TAU;

use crate::error::Error;

/// Least angle between two beams, radians.
pub(super) const LEAST_GAP: f32 = 1e-5;

/// A full turn, radians, with room for the rounding of a last beam that repeats the first.
const TURN: f32 = TAU + 0.01;

/// One sweep of a planar range sensor with beams at any angles, borrowed: Isaac's `FlatscanProto`.
///
/// Angles are radians in the sensor's frame, counter-clockwise from its x axis, ascending; ranges are
/// metres and follow REP 117.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flatscan<'a> {
    /// Directions of the beams: ascending by at least 1e-5, within +-2 pi, over at most a full turn.
    pub angles: &'a [f32],
    /// One range per beam: NaN and -inf say nothing, +inf is no hit.
    pub ranges: &'a [f32],
    /// Ranges up to and including this say nothing, metres, not negative.
    pub invalid_range_threshold: f32,
    /// Ranges from this on are no hit, metres; may be infinite.
    pub out_of_range_threshold: f32,
    /// How far each beam could see, metres: cells at or beyond that are left uncertain. Not NaN.
    pub visibilities: Option<&'a [f32]>,
}

impl Flatscan<'_> {
    /// Checks everything but the ranges, of which every value means something.
    ///
    /// # Errors
    /// [`Error::EmptyScan`] without beams; [`Error::LengthMismatch`] unless there are as many ranges
    /// and visibilities as angles; [`Error::InvalidScan`] for angles that are not finite, not
    /// ascending or too far apart, thresholds that are NaN or out of order, and visibilities that are
    /// NaN.
    ///
    /// # Complexity
    /// One read per beam.
    pub fn validate(&self) -> Result<(), Error> {
        let beams = self.angles.len();
        let (Some(first), Some(last)) = (self.angles.first(), self.angles.last()) else {
            return Err(Error::EmptyScan);
        };
        let lengths = [Some(self.ranges.len()), self.visibilities.map(<[f32]>::len)];
        if let Some(given) = lengths.into_iter().flatten().find(|given| *given != beams) {
            return Err(Error::LengthMismatch { needed: beams, given });
        }
        let ascending = self.angles.iter().zip(self.angles.iter().skip(1));
        let valid = self.angles.iter().all(|angle| angle.abs() <= TURN)
            && ascending.into_iter().all(|(a, b)| b - a >= LEAST_GAP)
            && last - first <= TURN
            && self.invalid_range_threshold >= 0.0
            && self.invalid_range_threshold <= self.out_of_range_threshold
            && !self.visibilities.unwrap_or_default().iter().any(|v| v.is_nan());
        if valid { Ok(()) } else { Err(Error::InvalidScan) }
    }
}
