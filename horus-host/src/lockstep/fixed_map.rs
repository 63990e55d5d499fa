use horus_core::prelude::Pose2D;

use super::core_side::CoreSide;
use super::{CoreStorage, LockstepConfig, LockstepError};

/// The core's cost map of cells that are given at once, where they are.
pub struct FixedMap<'a> {
    core: CoreSide<'a>,
}

impl<'a> FixedMap<'a> {
    /// Takes `cells` (row-major from the lowest y, -1 unknown, 0 to 100) and computes their costs. The
    /// corner of cell (0, 0) lies at `origin`.
    ///
    /// # Errors
    /// As [`CoreStorage::new`]; an error too if the storage was made for another configuration, or if
    /// the number of cells is another.
    ///
    /// # Complexity
    /// That of a full recompute of the core.
    pub fn new(
        config: &LockstepConfig,
        origin: Pose2D,
        cells: &[i8],
        storage: &'a mut CoreStorage,
    ) -> Result<Self, LockstepError> {
        config.validate()?;
        let mut core = CoreSide::new(config, origin, storage)?;
        core.load(cells)?;
        core.update_costs();
        Ok(Self { core })
    }

    /// The cells.
    pub fn occupancy(&self) -> &[i8] {
        self.core.occupancy()
    }

    /// Writes the costs of row `gy`, from the lowest x, as far as `costs` has room; none outside the map.
    pub fn read_row(&self, gy: u32, costs: &mut [u8]) {
        self.core.read_row(gy, costs);
    }
}
