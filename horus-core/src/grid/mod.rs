//! Occupancy grids: cell values, the rolling window, scans, and what algorithms may ask of any grid.

mod integrate;
mod occupancy;
mod requirements;
mod scan;
mod text;
mod workspace;

pub use occupancy::{OccupancyGrid, StaticOccupancyGrid};
pub use requirements::*;
pub use scan::{LaserScan, ScanModel, ScanReport};
pub use workspace::{BeamSlot, ScanBuffers, ScanWorkspace};

pub(crate) use integrate::ChangeSink;

/// Cell value: nothing is known.
pub const UNKNOWN: i8 = -1;
/// Cell value: free.
pub const FREE: i8 = 0;
/// Cell value: definitely occupied.
pub const OCCUPIED: i8 = 100;
/// Values from here on count as occupied, known ones below as free.
pub const OCCUPIED_FROM: i8 = 50;
