//! The std version of the rolling local map: navground's `LocalGridMap`, every decision in f32.

mod config;
mod draw;
mod footprint;
mod frame;
mod map;
mod scan;
mod state;
mod update;

pub use config::LocalGridMapConfig;
pub use footprint::LocalFootprint;
pub use map::LocalGridMap;
pub use scan::LidarScan;
pub use state::{SensingBuffer, SensingState};
pub use update::LocalUpdate;

/// An obstacle.
const OCCUPIED: u8 = 0;
/// Nothing is known.
const UNKNOWN: u8 = 128;
/// Free.
const FREE: u8 = 255;
