use super::super::Masses;
use crate::error::{Error, Parameter};

/// What a sensor's beams say about the cells they cover.
///
/// The defaults are ours; Isaac's are not public.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SensorModel {
    /// Masses of a cell before the hit; by default 0.4 free.
    pub m_free: Masses,
    /// Masses of a cell at the hit; by default 0.7 occupied.
    pub m_occ: Masses,
    /// How deep behind the hit the obstacle is taken to be, metres, finite, not negative; 0.1.
    pub wall_thickness: f32,
    /// How far a beam that hit nothing frees cells, metres; `None`: the scan's
    /// `out_of_range_threshold`.
    pub max_free_range: Option<f32>,
    /// Half the angle that each beam covers, radians, instead of half the gaps between beams: for
    /// sonars, and for scans of one beam, which have no gap.
    pub beam_half_width: Option<f32>,
}

impl Default for SensorModel {
    fn default() -> Self {
        Self {
            m_free: Masses::of_cell(0.4, 0.0),
            m_occ: Masses::of_cell(0.0, 0.7),
            wall_thickness: 0.1,
            max_free_range: None,
            beam_half_width: None,
        }
    }
}

impl SensorModel {
    /// An error unless scans of so many beams have widths.
    pub(crate) fn check_beams(&self, beams: usize) -> Result<(), Error> {
        if beams > 1 || self.beam_half_width.is_some() {
            Ok(())
        } else {
            Err(Error::InvalidScan)
        }
    }

    /// Checks the numbers.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`], which names the field.
    pub fn validate(&self) -> Result<(), Error> {
        let checks = [
            (
                self.wall_thickness.is_finite() && self.wall_thickness >= 0.0,
                Parameter::WallThickness,
            ),
            (
                self.max_free_range.is_none_or(|range| range >= 0.0),
                Parameter::MaxFreeRange,
            ),
            (
                self.beam_half_width.is_none_or(|width| width >= 0.0),
                Parameter::BeamHalfWidth,
            ),
        ];
        match checks.into_iter().find(|(valid, _)| !valid) {
            Some((_, parameter)) => Err(Error::InvalidParameter(parameter)),
            None => Ok(()),
        }
    }
}
