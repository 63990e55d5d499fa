use crate::grid::ValueTraits;

/// What unknown cells count as.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum UnknownAs {
    /// No obstacle, as in Beluga.
    #[default]
    Clear,
    /// An obstacle, as for a planner that keeps to known ground.
    Obstacle,
}

impl UnknownAs {
    /// Whether a cell of this value is an obstacle.
    #[inline]
    pub(super) fn is_obstacle<V: ValueTraits>(self, values: &V, value: V::Value) -> bool {
        values.is_occupied(value) || (self == Self::Obstacle && values.is_unknown(value))
    }
}

/// How distances are computed. All zero is the default.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DistanceOptions {
    /// The cap in squared cells: a greater distance, or none because there is no obstacle, reads as the cap.
    /// `None`, and whatever the map's cells cannot hold: the greatest that they can.
    pub max_squared: Option<u32>,
    /// What unknown cells count as.
    pub unknown: UnknownAs,
}

impl DistanceOptions {
    /// A cap in metres: the squared cells of `max_distance` metres, rounded up to a whole number. Not a number,
    /// or beyond what 32 bits hold: no cap.
    #[must_use]
    pub fn with_max_distance(self, max_distance: f32, resolution: f32) -> Self {
        let cells = max_distance / resolution;
        let squared = crate::math::ceil(cells * cells);
        Self {
            max_squared: (squared < 4_294_967_296.0).then_some(squared as u32),
            ..self
        }
    }
}
