use crate::error::{Error, Parameter};

/// Which masses make a cell of the binary map free or occupied.
///
/// Occupied if the mass occupied reaches its threshold (this wins), else free if the mass free reaches
/// its own, else free if `is_optimistic`, otherwise occupied.
///
/// Source: Isaac `EvidenceToBinaryMap`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BinaryThresholds {
    /// Least mass free, 0 to 1, of a free cell; rounded as the cells' masses are.
    pub free_threshold: f32,
    /// Least mass occupied, 0 to 1, of an occupied cell; rounded as the cells' masses are.
    pub occupied_threshold: f32,
    /// What a cell below both thresholds is: free (true) or occupied.
    pub is_optimistic: bool,
}

impl Default for BinaryThresholds {
    /// 0.3 free, 0.3 occupied, not optimistic.
    fn default() -> Self {
        Self {
            free_threshold: 0.3,
            occupied_threshold: 0.3,
            is_optimistic: false,
        }
    }
}

impl BinaryThresholds {
    /// Checks the numbers.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`].
    pub fn validate(&self) -> Result<(), Error> {
        let is_mass = |threshold: f32| (0.0..=1.0).contains(&threshold);
        if !is_mass(self.free_threshold) {
            Err(Error::InvalidParameter(Parameter::FreeThreshold))
        } else if !is_mass(self.occupied_threshold) {
            Err(Error::InvalidParameter(Parameter::OccupiedThreshold))
        } else {
            Ok(())
        }
    }
}
