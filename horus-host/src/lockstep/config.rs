use horus_core::prelude::{CostParams, Footprint, GridInfo, LocalGridMapConfig, Pose2D, ScanModel};

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
    /// Draw scans as navground's `LocalGridMap` does, with this footprint; `model` is not used then.
    pub local: Option<LocalMapping>,
}

/// What a local map frees around the robot.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LocalMapping {
    /// The shape.
    pub footprint: Footprint,
    /// Its radius in metres.
    pub radius: f32,
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
            local: None,
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
        if let Some(local) = self.local_config() {
            local.validate()?;
        }
        Ok(())
    }

    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.width as usize * self.height as usize
    }

    /// The local map: one lidar and one odometry sensor, whatever their names.
    pub(super) fn local_config(&self) -> Option<LocalGridMapConfig<'static>> {
        let LocalMapping { footprint, radius } = self.local?;
        Some(LocalGridMapConfig {
            width: self.width,
            height: self.height,
            resolution: self.resolution,
            external_lidars: &[super::local::LIDAR],
            external_odometry: super::local::ODOMETRY,
            footprint,
            radius,
            ..LocalGridMapConfig::default()
        })
    }

    /// Where the corner of cell (0, 0) lies before the window first moves: the frame's origin is
    /// then in the middle of the map, or at its corner for a local map.
    pub fn origin(&self) -> Pose2D {
        if self.local.is_some() {
            return Pose2D::default();
        }
        let half = |size: u32| -(size as f32 * self.resolution) * 0.5;
        Pose2D::new(half(self.width), half(self.height), 0.0)
    }
}
