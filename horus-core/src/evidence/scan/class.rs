use super::super::Masses;
use super::SensorModel;

/// What a scan says about a cell.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(u8)]
pub enum ScanClass {
    /// Nothing: no beam covers it, or it lies behind the hit.
    #[default]
    Vacuous = 0,
    /// Before the hit.
    Free = 1,
    /// At the hit.
    Occupied = 2,
}

impl ScanClass {
    /// The masses that a sensor gives to such a cell.
    pub fn masses(self, model: &SensorModel) -> Masses {
        match self {
            Self::Vacuous => Masses::VACUOUS,
            Self::Free => model.m_free,
            Self::Occupied => model.m_occ,
        }
    }

    pub(super) fn of_bits(bits: u8) -> Self {
        match bits {
            1 => Self::Free,
            2 => Self::Occupied,
            _ => Self::Vacuous,
        }
    }
}
