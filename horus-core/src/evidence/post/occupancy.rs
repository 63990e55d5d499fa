use super::super::MassCell;
use crate::error::{Error, Parameter};

/// Occupancy values of evidence: each cell's pignistic probability o + u / 2 in percent, 0 to 100, or
/// unknown where more than `max_uncertain`, 0 to 1, is uncertain. What
/// [`CostMap::load`](crate::costmap::CostMap::load) takes.
///
/// # Errors
/// [`Error::InvalidParameter`]; [`Error::LengthMismatch`] unless there is one value per cell. Nothing
/// is written then.
///
/// # Complexity
/// One read and one write per cell.
///
/// ```
/// use horus_core::evidence::{EvidenceU16, MassCell, Masses, evidence_to_occupancy};
///
/// let cell = |f, o, u| Masses::new(f, o, u).map(EvidenceU16::from_masses);
/// let mut values = [0; 3];
/// evidence_to_occupancy(&[EvidenceU16::VACUOUS, cell(0.4, 0.0, 0.6)?, cell(0.0, 1.0, 0.0)?], 0.9, &mut values)?;
/// assert_eq!(values, [-1, 30, 100]);
/// # Ok::<(), horus_core::Error>(())
/// ```
pub fn evidence_to_occupancy<M: MassCell>(
    cells: &[M],
    max_uncertain: f32,
    values: &mut [i8],
) -> Result<(), Error> {
    if !(0.0..=1.0).contains(&max_uncertain) {
        return Err(Error::InvalidParameter(Parameter::MaxUncertain));
    }
    if cells.len() != values.len() {
        return Err(Error::LengthMismatch {
            needed: cells.len(),
            given: values.len(),
        });
    }
    for (value, cell) in values.iter_mut().zip(cells) {
        *value = cell.masses().occupancy(max_uncertain);
    }
    Ok(())
}
