use horus_core::prelude::{CostParams, GridInfo, Pose2D, ScanModel};

use super::LockstepError;

/// The map that both sides keep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LockstepConfig {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Metres per cell.
    pub resolution: f32,
    /// Parameters of the cost map.
    pub params: CostParams,
    /// How scans change cells.
    pub model: ScanModel,
    /// Whether the core keeps its costs as bytes, one more per cell, instead of reading them through
    /// the map.
    pub keep_costs: bool,
}

impl Default for LockstepConfig {
    /// 200 x 200 cells of 0.05 m with default parameters, `Set` scans and no kept costs.
    fn default() -> Self {
        Self {
            width: 200,
            height: 200,
            resolution: 0.05,
            params: CostParams::default(),
            model: ScanModel::Set,
            keep_costs: false,
        }
    }
}

impl LockstepConfig {
    /// The largest number of cells of a map: 4096 x 4096.
    pub const MOST_CELLS: u64 = 1 << 24;

    /// Checks size, resolution and parameters.
    ///
    /// # Errors
    /// [`LockstepError::Size`]; [`LockstepError::Core`] with the core's reason.
    pub fn validate(&self) -> Result<(), LockstepError> {
        let cells = u64::from(self.width) * u64::from(self.height);
        if cells == 0 || cells > Self::MOST_CELLS {
            return Err(LockstepError::Size {
                width: self.width,
                height: self.height,
                most: Self::MOST_CELLS,
            });
        }
        GridInfo::new(self.width, self.height, self.resolution, self.origin())?;
        self.params.validate()?;
        Ok(())
    }

    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.width as usize * self.height as usize
    }

    /// Where the corner of cell (0, 0) lies before the window first moves: the frame's origin is
    /// then in the middle of the map.
    pub fn origin(&self) -> Pose2D {
        let half = |size: u32| -(size as f32 * self.resolution) * 0.5;
        Pose2D::new(half(self.width), half(self.height), 0.0)
    }
}
