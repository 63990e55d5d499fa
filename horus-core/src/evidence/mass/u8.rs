use super::super::fusion::integer::{self, IntegerCell};
use super::super::fusion::{FusionOperator, FusionRule, Kernel, PreparedRule, Tally};
use super::integer::integer_cell;
use super::{MassCell, Masses};
use crate::error::Error;

integer_cell! {
    /// A mass cell of 2 bytes: 8-bit fixed point, full scale 255, for sensor masses of 0.3 or more.
    ///
    /// Under PCR6 the error after any number of fusions is at most q (1 + w)^2 / w^3 with
    /// q = 0.5 / 255, for uninterpolated sensor masses of at least w: 0.13 at w = 0.3, useless below.
    /// Dempster's and Josang's cumulative rule are refused: errors under them reach 0.8.
    EvidenceU8, u8, 8, |rule: FusionRule| match rule.operator {
        FusionOperator::Pcr6 | FusionOperator::JosangAverage => Ok(()),
        FusionOperator::DempsterShafer | FusionOperator::JosangCumulative => Err(Error::UnsupportedFusion),
    }
}
