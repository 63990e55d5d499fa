use core::fmt;
use core::str::FromStr;

use crate::error::Error;

/// How two pieces of evidence about a cell become one, by the names of Isaac's `fusion_operator`.
///
/// With K = f1 o2 + o1 f2 (the conflict), Cf = f1 f2 + f1 u2 + u1 f2, Co likewise, Cu = u1 u2:
///
/// | operator | result | limits |
/// |---|---|---|
/// | PCR6 | f = Cf + f1^2 o2 / (f1 + o2) + f2^2 o1 / (f2 + o1), o likewise, u = Cu | a term with denominator 0 is 0 |
/// | Dempster-Shafer | C / (1 - K) | K = 1: the cell becomes vacuous, and is counted |
/// | Josang average | b = (b1 u2 + b2 u1) / (u1 + u2), u = 2 u1 u2 / (u1 + u2) | u1 = u2 = 0: the mean |
/// | Josang cumulative | b = (b1 u2 + b2 u1) / d, u = u1 u2 / d, d = u1 + u2 - u1 u2 | u1 = u2 = 0: the mean |
///
/// All are commutative; none but Dempster's is associative, so sensors are fused pairwise in a fixed
/// order. Under the average a vacuous input is **not** neutral (0.9 becomes 0.82, 0.69, ...): cells
/// that no beam covers are fused, too, and forget what they knew.
///
/// Source: Smarandache and Dezert 2005 (PCR), Josang 2016 (belief fusion operators).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum FusionOperator {
    /// Proportional conflict redistribution, rule 6 (of two sources: also rule 5).
    #[default]
    Pcr6,
    /// Dempster's rule of combination.
    DempsterShafer,
    /// Josang's averaging belief fusion.
    JosangAverage,
    /// Josang's cumulative belief fusion.
    JosangCumulative,
}

impl FusionOperator {
    /// All four, the default first.
    pub const ALL: [Self; 4] = [
        Self::Pcr6,
        Self::DempsterShafer,
        Self::JosangAverage,
        Self::JosangCumulative,
    ];

    /// Isaac's name: `pcr6`, `dempster_shafer`, `josang_average`, `josang_cumulative`.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Pcr6 => "pcr6",
            Self::DempsterShafer => "dempster_shafer",
            Self::JosangAverage => "josang_average",
            Self::JosangCumulative => "josang_cumulative",
        }
    }

    /// True if knowledge locks in under this rule, so that it takes an ignorance floor.
    pub(crate) const fn is_floored(self) -> bool {
        matches!(self, Self::DempsterShafer | Self::JosangCumulative)
    }
}

impl FromStr for FusionOperator {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self, Error> {
        let named = Self::ALL.into_iter().find(|operator| operator.as_str() == name);
        named.ok_or(Error::UnknownFusionOperator)
    }
}

impl fmt::Display for FusionOperator {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}
