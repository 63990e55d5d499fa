use crate::error::{Error, Parameter};
use crate::geometry::CELL_LIMIT;
use crate::math;

/// How inflated cost falls with the distance d (metres) to the nearest source.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Decay {
    /// HORUS: `trunc((lethal_cost - 1) * (1 - d / R)^k)` for d <= R.
    #[default]
    Polynomial,
    /// nav2: 254 at d = 0, 253 up to the inscribed radius, then
    /// `trunc(252 * exp(-k * (d - inscribed_radius)))` within R rounded up to whole cells.
    Exponential,
}

/// Parameters of a cost map; all may change at run time.
///
/// A cell's base cost comes from its occupancy v: unknown 255; `v >= lethal_threshold`
/// `lethal_cost`; else `min(2 v, lethal_cost - 1)`. Lethal cells are the sources of inflation.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CostParams {
    /// R, metres, finite and >= 0.
    pub inflation_radius: f32,
    /// k, finite and >= 0: an exponent (Polynomial) or 1/m (Exponential).
    pub cost_scaling_factor: f32,
    /// Cost of lethal cells, 2..=254.
    pub lethal_cost: u8,
    /// Lowest occupancy that is lethal, 1..=100.
    pub lethal_threshold: i8,
    /// Unknown cells are sources too.
    pub unknown_inflates: bool,
    /// The law of decay.
    pub decay: Decay,
    /// Metres, finite and >= 0; Exponential only.
    pub inscribed_radius: f32,
    /// Unknown cells take any inflated cost above zero, not only 253 and 254; Exponential only.
    pub inflate_unknown: bool,
}

impl Default for CostParams {
    fn default() -> Self {
        Self {
            inflation_radius: 0.55,
            cost_scaling_factor: 10.0,
            lethal_cost: 253,
            lethal_threshold: 50,
            unknown_inflates: false,
            decay: Decay::Polynomial,
            inscribed_radius: 0.1,
            inflate_unknown: false,
        }
    }
}

impl CostParams {
    /// HORUS 0.4.1: the defaults with threshold 65, and unknown cells inflate.
    pub fn horus() -> Self {
        Self {
            lethal_threshold: 65,
            unknown_inflates: true,
            ..Self::default()
        }
    }

    /// nav2's inflation layer: Exponential, lethal cost 254 from occupancy 100 on.
    pub fn nav2() -> Self {
        Self {
            lethal_cost: 254,
            lethal_threshold: 100,
            decay: Decay::Exponential,
            ..Self::default()
        }
    }

    /// The same parameters with another inflation radius in metres.
    pub fn with_radius(self, inflation_radius: f32) -> Self {
        Self {
            inflation_radius,
            ..self
        }
    }

    /// Checks every field against its documented range.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] naming the first field that is out of range.
    pub fn validate(&self) -> Result<(), Error> {
        let is_length = |v: f32| v.is_finite() && v >= 0.0;
        let parameter = if !is_length(self.inflation_radius) {
            Parameter::InflationRadius
        } else if !is_length(self.cost_scaling_factor) {
            Parameter::CostScalingFactor
        } else if !(2..=254).contains(&self.lethal_cost) {
            Parameter::LethalCost
        } else if !(1..=100).contains(&self.lethal_threshold) {
            Parameter::LethalThreshold
        } else if !is_length(self.inscribed_radius) {
            Parameter::InscribedRadius
        } else {
            return Ok(());
        };
        Err(Error::InvalidParameter(parameter))
    }

    /// Base cost of an occupancy value.
    pub(crate) fn base_cost(&self, occupancy: i8) -> u8 {
        if occupancy < 0 {
            super::UNKNOWN_COST
        } else if occupancy >= self.lethal_threshold {
            self.lethal_cost
        } else {
            (2 * occupancy as u8).min(self.lethal_cost - 1)
        }
    }

    /// Inflated cost at a squared distance in cells, f32 in the order SPEC 3 writes.
    pub(crate) fn inflated_cost(&self, squared_cells: u32, resolution: f32) -> u8 {
        let d = resolution * math::sqrt(squared_cells as f32);
        match self.decay {
            Decay::Polynomial => {
                if self.inflation_radius == 0.0 || d > self.inflation_radius {
                    return 0;
                }
                let fraction = math::pow(1.0 - d / self.inflation_radius, self.cost_scaling_factor);
                (f32::from(self.lethal_cost - 1) * fraction) as u8
            }
            Decay::Exponential => {
                let n = math::ceil(self.inflation_radius / resolution - 1.0 / 1024.0);
                let n = (n as i32).clamp(0, CELL_LIMIT) as u64;
                if u64::from(squared_cells) > n * n {
                    0
                } else if squared_cells == 0 {
                    254
                } else if d <= self.inscribed_radius {
                    253
                } else {
                    (252.0 * math::exp(-self.cost_scaling_factor * (d - self.inscribed_radius))) as u8
                }
            }
        }
    }
}
