use crate::grid::ValueTraits;
use crate::math;

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
    /// A cap in metres: the squared cells of `max_distance` metres, rounded up to a whole number. Within 2^-10
    /// of a whole number of cells it is that many: 0.3 m is 30 cells of 0.01 m, though not in f32. A negative
    /// maximum is 0. Not a number, or beyond what 32 bits hold: no cap.
    #[must_use]
    pub fn with_max_distance(self, max_distance: f32, resolution: f32) -> Self {
        let cells = max_distance / resolution;
        let whole = math::rint(cells);
        // 0 cells are what is asked for only where the maximum is 0.
        let is_whole = whole != 0.0 && (cells - whole).abs() <= 1.0 / 1024.0;
        let cells = if is_whole { whole } else { cells };
        let cells = if cells < 0.0 { 0.0 } else { cells };
        let squared = math::ceil(cells * cells);
        Self {
            max_squared: (squared < 4_294_967_296.0).then_some(squared as u32),
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::DistanceOptions;

    fn cap(max_distance: f32, resolution: f32) -> Option<u32> {
        DistanceOptions::default()
            .with_max_distance(max_distance, resolution)
            .max_squared
    }

    #[test]
    fn decimal_multiples_of_a_cell_are_whole() {
        for hundredths in 1..=40u16 {
            for cells in 1..=200u16 {
                let resolution = f32::from(hundredths) / 100.0;
                let metres = f32::from(hundredths * cells) / 100.0;
                let expected = u32::from(cells) * u32::from(cells);
                assert_eq!(cap(metres, resolution), Some(expected), "{metres} / {resolution}");
            }
        }
    }

    #[test]
    fn other_maxima_are_rounded_up() {
        assert_eq!(cap(1.25, 0.5), Some(7));
        assert_eq!(cap(-1.0, 0.5), Some(0));
        assert_eq!(cap(0.0, 0.5), Some(0));
        assert_eq!(cap(4e-5, 0.05), Some(1));
        assert_eq!(cap(f32::INFINITY, 0.5), None);
        assert_eq!(cap(f32::NAN, 0.5), None);
        assert_eq!(cap(1.0, 0.0), None);
    }
}
