//! The names most users need: `use horus_core::prelude::*;`

pub use crate::costmap::{
    CostBuffers, CostMap, CostMapBuffers, CostParams, CostUpdate, Decay, FootprintCost,
};
pub use crate::error::Error;
pub use crate::geometry::{CellRect, GridInfo, Pose2D};
pub use crate::grid::{
    BeamSlot, LaserScan, OccupancyGrid, ScanBuffers, ScanModel, ScanReport, ScanWorkspace,
    StaticOccupancyGrid,
};
pub use crate::local::{
    Footprint, Lidar, LocalGridMap, LocalGridMapConfig, LocalUpdate, Odometry, SensingBuffers, SensingState,
};
