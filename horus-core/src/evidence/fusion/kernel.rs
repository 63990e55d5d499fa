use super::{PreparedRule, Tally};
use crate::evidence::Masses;

/// Weights of an interpolation sum to this.
pub(crate) const WHOLE: u32 = 1 << 31;

/// What the crate does with slices of a mass cell; nothing outside can implement it.
pub trait Kernel: Sized {
    /// Conflict mass per unit of a [`Tally`].
    #[doc(hidden)]
    const CONFLICT_UNIT: f32;
    /// The two masses of a sensor, ready to be mixed.
    #[doc(hidden)]
    type Blend: Copy + core::fmt::Debug;

    /// `state[i] = state[i] + sensor[i]` under the rule, as far as both reach.
    #[doc(hidden)]
    fn fuse(rule: &PreparedRule, state: &mut [Self], sensor: &[Self]) -> Tally;

    /// The mean of four cells under weights that sum to 2^31.
    #[doc(hidden)]
    fn interpolate(corners: [Self; 4], weights: [u32; 4]) -> Self;

    /// Prepares a sensor's masses.
    #[doc(hidden)]
    fn blend(free: Masses, occupied: Masses) -> Self::Blend;

    /// The mean of a sensor's two masses and the vacuous state under weights of which those of the
    /// former are given; all sum to 2^31.
    #[doc(hidden)]
    fn mix(blend: &Self::Blend, free: u32, occupied: u32) -> Self;

    /// A mass as a number that compares as masses of this type do.
    #[doc(hidden)]
    fn steps(mass: f32) -> u32;

    /// The cell's masses free and occupied, as numbers to compare with [`steps`](Self::steps).
    #[doc(hidden)]
    fn in_steps(self) -> (u32, u32);
}
