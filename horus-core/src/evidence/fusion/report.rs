use super::Kernel;

/// What a fusion met.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FusionReport {
    /// Cells in which the two sides contradict each other: K > 0.
    pub conflicts: u32,
    /// The sum of K, the mass in conflict, over all cells.
    pub conflict_mass: f32,
    /// Cells that became vacuous because the conflict was total, K = 1, and Dempster's rule is
    /// undefined there.
    pub undefined: u32,
}

/// The same while it is counted: conflict mass in units of the cell type.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tally {
    pub(crate) conflicts: u32,
    pub(crate) mass: u64,
    pub(crate) undefined: u32,
}

impl Tally {
    /// Counts the conflict of one cell.
    #[inline(always)]
    pub(super) fn count(&mut self, conflict: u32) {
        self.conflicts = self.conflicts.wrapping_add(u32::from(conflict != 0));
        self.mass = self.mass.wrapping_add(u64::from(conflict));
    }

    pub(crate) fn add(&mut self, other: Self) {
        self.conflicts = self.conflicts.saturating_add(other.conflicts);
        self.mass = self.mass.saturating_add(other.mass);
        self.undefined = self.undefined.saturating_add(other.undefined);
    }

    pub(crate) fn report<M: Kernel>(self) -> FusionReport {
        FusionReport {
            conflicts: self.conflicts,
            conflict_mass: self.mass as f32 * M::CONFLICT_UNIT,
            undefined: self.undefined,
        }
    }
}
