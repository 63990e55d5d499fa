use super::FusionOperator;
use crate::error::{Error, Parameter};

/// A fusion operator with its ignorance floor.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FusionRule {
    /// The operator.
    pub operator: FusionOperator,
    /// Least uncertain mass that a fusion by Dempster's or Josang's cumulative rule leaves, 0 (off)
    /// to below 1. Without one, both lock in: after a long quiet phase no evidence changes them. The
    /// other two ignore it.
    pub ignorance_floor: f32,
}

impl Default for FusionRule {
    fn default() -> Self {
        Self::new(FusionOperator::default())
    }
}

impl FusionRule {
    /// The operator with the default floor, 0.02.
    pub const fn new(operator: FusionOperator) -> Self {
        Self {
            operator,
            ignorance_floor: 0.02,
        }
    }

    /// Checks the floor.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`].
    pub fn validate(&self) -> Result<(), Error> {
        if (0.0..1.0).contains(&self.ignorance_floor) {
            Ok(())
        } else {
            Err(Error::InvalidParameter(Parameter::IgnoranceFloor))
        }
    }
}

/// A rule as the kernels use it.
#[derive(Clone, Copy, Debug)]
pub struct PreparedRule {
    pub(crate) operator: FusionOperator,
    /// The floor; 0 under the operators that have none.
    pub(crate) floor: f32,
}

impl PreparedRule {
    pub(crate) fn new(rule: FusionRule) -> Result<Self, Error> {
        rule.validate()?;
        let floor = if rule.operator.is_floored() {
            rule.ignorance_floor
        } else {
            0.0
        };
        Ok(Self {
            operator: rule.operator,
            floor,
        })
    }

    /// True if fusing a vacuous cell changes nothing: also under a floor, since every state that a
    /// fusion has left respects it.
    pub(crate) fn vacuous_is_neutral(&self) -> bool {
        self.operator != FusionOperator::JosangAverage
    }
}
