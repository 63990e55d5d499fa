//! Fusion of mass cells: operators, rules, reports, and the kernels over slices.

pub(crate) mod float;
pub(crate) mod integer;
mod kernel;
mod operator;
mod report;
mod rule;
mod share;

pub use self::kernel::Kernel;
pub(crate) use self::kernel::WHOLE;
pub use self::operator::FusionOperator;
pub use self::report::{FusionReport, Tally};
pub use self::rule::{FusionRule, PreparedRule};

use super::MassCell;
use crate::error::Error;

/// Both as far as the shorter reaches, so that what is fused side by side belongs together.
#[inline(always)]
fn same_length<'s, M>(state: &'s mut [M], sensor: &'s [M]) -> (&'s mut [M], &'s [M]) {
    let both = state.len().min(sensor.len());
    (
        state.get_mut(..both).unwrap_or_default(),
        sensor.get(..both).unwrap_or_default(),
    )
}

/// Whether cells are fused several at a time, in f64 where that is exact: on 64-bit hosts, all of which
/// have vector registers and f64. Both ways give the same bits.
const HAS_VECTORS: bool = cfg!(all(target_pointer_width = "64", not(horus_bits_kernel)));

/// Fuses cells pairwise: `state[i]` becomes `state[i]` fused with `sensor[i]`.
///
/// # Errors
/// [`Error::InvalidParameter`] for a floor outside [0, 1); [`Error::UnsupportedFusion`];
/// [`Error::LengthMismatch`] unless both have the same length. The state stays as it was then.
///
/// # Complexity
/// One read per sensor cell, one read and one write per cell of the state.
///
/// # Examples
/// ```
/// use horus_core::evidence::{EvidenceU16, FusionOperator, FusionRule, MassCell, Masses, fuse};
///
/// let cell = |f, o, u| Masses::new(f, o, u).map(EvidenceU16::from_masses);
/// let mut state = [cell(0.6, 0.0, 0.4)?];
/// let report = fuse(FusionRule::new(FusionOperator::Pcr6), &mut state, &[cell(0.0, 0.3, 0.7)?])?;
/// let fused = state[0].masses();
/// assert!((fused.free() - 0.54).abs() < 1e-4 && (fused.occupied() - 0.18).abs() < 1e-4);
/// assert_eq!(report.conflicts, 1);
/// # Ok::<(), horus_core::Error>(())
/// ```
pub fn fuse<M: MassCell>(rule: FusionRule, state: &mut [M], sensor: &[M]) -> Result<FusionReport, Error> {
    M::supports(rule)?;
    let prepared = PreparedRule::new(rule)?;
    if state.len() != sensor.len() {
        return Err(Error::LengthMismatch {
            needed: state.len(),
            given: sensor.len(),
        });
    }
    Ok(M::fuse(&prepared, state, sensor).report::<M>())
}
