use super::{Decay, ReferenceError};

/// Everything that decides how occupancy becomes cost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CostParams {
    /// Metres around an obstacle that get a raised cost: finite, not negative.
    pub inflation_radius: f32,
    /// How fast the cost falls, larger is faster: finite, not negative.
    pub cost_scaling_factor: f32,
    /// Cost of an obstacle cell: 2 to 254.
    pub lethal_cost: u8,
    /// Smallest occupancy that is an obstacle: 1 to 100.
    pub lethal_threshold: i8,
    /// Whether cost is also inflated around unknown cells.
    pub unknown_inflates: bool,
    /// How the cost falls with distance.
    pub decay: Decay,
    /// Exponential only: metres around an obstacle that cost 253: finite, not negative.
    pub inscribed_radius: f32,
    /// Exponential only: whether an unknown cell takes any inflated cost above 0, instead of 253 and 254 only.
    pub inflate_unknown: bool,
}

impl CostParams {
    /// Behaves as HORUS 0.4.1 wherever that is well-defined: its hard-wired threshold, and inflation around unknown.
    pub fn horus() -> Self {
        Self {
            lethal_threshold: 65,
            unknown_inflates: true,
            ..Self::default()
        }
    }

    /// Behaves as the inflation layer of nav2 with its default parameters.
    pub fn nav2() -> Self {
        Self {
            lethal_cost: 254,
            lethal_threshold: 100,
            decay: Decay::Exponential,
            ..Self::default()
        }
    }

    /// Checks every range given at the fields.
    ///
    /// # Errors
    /// The first parameter outside its range.
    pub fn validate(&self) -> Result<(), ReferenceError> {
        let metres = "finite and not negative";
        let is_length = |v: f32| v.is_finite() && v >= 0.0;
        let (lethal, threshold) = (self.lethal_cost, self.lethal_threshold);
        let (radius, factor, inscribed) = (
            self.inflation_radius,
            self.cost_scaling_factor,
            self.inscribed_radius,
        );
        [
            ("inflation_radius", metres, radius, is_length(radius)),
            ("cost_scaling_factor", metres, factor, is_length(factor)),
            ("inscribed_radius", metres, inscribed, is_length(inscribed)),
            (
                "lethal_cost",
                "2 to 254",
                f32::from(lethal),
                (2..=254).contains(&lethal),
            ),
            (
                "lethal_threshold",
                "1 to 100",
                f32::from(threshold),
                (1..=100).contains(&threshold),
            ),
        ]
        .into_iter()
        .find(|&(.., legal)| !legal)
        .map_or(Ok(()), |(name, expected, value, _)| {
            Err(ReferenceError::CostParam {
                name,
                expected,
                value,
            })
        })
    }
}

impl Default for CostParams {
    /// The seed's cost map: 0.55 m, factor 10, lethal 253 from occupancy 50 on, polynomial decay.
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
