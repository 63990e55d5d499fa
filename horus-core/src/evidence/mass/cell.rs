use core::fmt::Debug;

use super::super::fusion::{FusionRule, Kernel};
use super::Masses;
use crate::error::Error;

/// A cell of an evidence grid: the masses free and occupied; what they leave of 1 is uncertain.
///
/// All bits zero is the vacuous cell. The integer types keep the sum of the three masses exactly 1.
///
/// | type | bytes | step | PCR6, error after any number of fusions |
/// |---|---|---|---|
/// | [`EvidenceU16`](super::EvidenceU16) | 4 | 1 / 65535 | at most q (1 + w)^2 / w^3, q = 0.5 / 65535, for uninterpolated sensor masses >= w |
/// | [`EvidenceU8`](super::EvidenceU8) | 2 | 1 / 255 | the same with q = 0.5 / 255: for sensor masses of 0.3 or more |
/// | [`EvidenceF32`](super::EvidenceF32) | 8 | 2^-24 | renormalised at each fusion, so that nothing drifts |
///
/// This trait is sealed: its kernels are written for these three.
pub trait MassCell: Kernel + Copy + Debug + Default + PartialEq + 'static {
    /// The vacuous cell, all bits zero.
    const VACUOUS: Self;

    /// The nearest cell to the masses, halves up; where rounding exceeds the whole, free gives way.
    fn from_masses(masses: Masses) -> Self;

    /// The cell's masses as numbers.
    fn masses(self) -> Masses;

    /// True if nothing is known of the cell.
    fn is_vacuous(self) -> bool {
        self == Self::VACUOUS
    }

    /// Checks that the rule may be used with this type.
    ///
    /// # Errors
    /// [`Error::UnsupportedFusion`]: `u8` cells under Dempster's and Josang's cumulative rule, where
    /// their errors reach 0.8.
    fn supports(rule: FusionRule) -> Result<(), Error> {
        let _ = rule;
        Ok(())
    }
}
