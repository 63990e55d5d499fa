//! The names a program needs to use the std version of the grid and the cost map, in one `use`.

pub use crate::reference::{
    CostMap, CostParams, Decay, FootprintCost, LaserScan, OccupancyGrid, Pose2D, Rect, ReferenceError,
    ScanModel, ScanReport,
};
