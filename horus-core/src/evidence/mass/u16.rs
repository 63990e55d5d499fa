use super::super::fusion::integer::{self, IntegerCell};
use super::super::fusion::{FusionRule, Kernel, PreparedRule, Tally};
use super::integer::integer_cell;
use super::{MassCell, Masses};
use crate::error::Error;

integer_cell! {
    /// A mass cell of 4 bytes: 16-bit fixed point, full scale 65535. The default.
    ///
    /// One fusion leaves free and occupied within 0.506 steps of the exact result, uncertain within
    /// one. Under PCR6 the error after any number of fusions is at most q (1 + w)^2 / w^3 with
    /// q = 0.5 / 65535, for uninterpolated sensor masses of at least w.
    ///
    /// ```
    /// use horus_core::evidence::{EvidenceU16, MassCell, Masses};
    ///
    /// let cell = EvidenceU16::from_masses(Masses::new(0.4, 0.0, 0.6)?);
    /// assert_eq!((cell.free_steps(), cell.uncertain_steps()), (26214, 39321));
    /// # Ok::<(), horus_core::Error>(())
    /// ```
    EvidenceU16, u16, 16, |_: FusionRule| Ok(())
}
