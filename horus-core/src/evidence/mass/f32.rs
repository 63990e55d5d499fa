use super::super::fusion::{Kernel, PreparedRule, Tally, float};
use super::{MassCell, Masses};

/// A mass cell of 8 bytes: two f32. Their sum is kept a mass at each fusion, so that nothing drifts.
///
/// The uncertain mass is what the other two leave of 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(C)]
pub struct EvidenceF32 {
    free: f32,
    occupied: f32,
}

impl EvidenceF32 {
    /// Two masses that sum to at most 1, up to rounding.
    #[inline(always)]
    pub(crate) fn of(free: f32, occupied: f32) -> Self {
        Self { free, occupied }
    }

    #[inline(always)]
    pub(crate) fn parts(self) -> (f32, f32) {
        (self.free, self.occupied)
    }
}

impl MassCell for EvidenceF32 {
    const VACUOUS: Self = Self {
        free: 0.0,
        occupied: 0.0,
    };

    fn from_masses(masses: Masses) -> Self {
        float::bounded(masses.free(), masses.occupied())
    }

    fn masses(self) -> Masses {
        Masses::of_cell(self.free, self.occupied)
    }
}

impl Kernel for EvidenceF32 {
    const CONFLICT_UNIT: f32 = float::CONFLICT_UNIT;
    type Blend = [Masses; 2];

    #[inline(never)]
    fn fuse(rule: &PreparedRule, state: &mut [Self], sensor: &[Self]) -> Tally {
        float::fuse(rule, state, sensor)
    }

    fn interpolate(corners: [Self; 4], weights: [u32; 4]) -> Self {
        float::interpolate(corners, weights)
    }

    fn blend(free: Masses, occupied: Masses) -> Self::Blend {
        [free, occupied]
    }

    fn mix(blend: &Self::Blend, free: u32, occupied: u32) -> Self {
        float::mix(blend, free, occupied)
    }

    // Masses are not negative, so that their bits are in their order.
    fn steps(mass: f32) -> u32 {
        mass.abs().to_bits()
    }

    fn in_steps(self) -> (u32, u32) {
        (self.free.abs().to_bits(), self.occupied.abs().to_bits())
    }
}
