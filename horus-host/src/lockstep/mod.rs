//! Core and std version side by side: the same scans into both, every cell compared after each.
//!
//! A [`Lockstep`] takes one tick after the other: a scan, the robot's pose and the sensor's pose in
//! the frame of the map, rounded to f32 once. Both sides move their window, integrate the scan and
//! update their costs, each timed on its own; then window, scan report, occupancy and cost of every
//! cell are compared. The field type of the core follows from the parameters ([`FieldWidth`]), its
//! memory lies in a [`CoreStorage`] that is allocated once. A [`FixedMap`] is the core's side alone,
//! for a map that is given and stays where it is.
//!
//! # Examples
//! ```
//! use horus_core::prelude::{LaserScan, Pose2D};
//! use horus_host::lockstep::{CoreStorage, Lockstep, LockstepConfig};
//!
//! let config = LockstepConfig { width: 60, height: 60, ..LockstepConfig::default() };
//! let mut storage = CoreStorage::new(&config, 3)?;
//! let mut lockstep = Lockstep::new(&config, &mut storage)?;
//! let scan = LaserScan {
//!     angle_min: -0.1,
//!     angle_increment: 0.1,
//!     range_min: 0.1,
//!     range_max: 8.0,
//!     ranges: &[0.5, f32::INFINITY, 0.9],
//! };
//! let pose = Pose2D::new(3.0, 4.0, 1.0);
//! assert_eq!(lockstep.tick(0, &scan, pose, pose), None, "no call was refused");
//! assert_eq!(lockstep.totals().cells_compared, 2 * 60 * 60);
//! assert!(lockstep.first_mismatch().is_none());
//! # Ok::<(), horus_host::lockstep::LockstepError>(())
//! ```

mod comparison;
mod config;
mod core_side;
mod engine;
mod error;
pub mod evidence;
mod field;
mod fixed_map;
mod layers;
mod local;
mod mismatch;
mod ram;
mod std_side;
mod storage;
#[cfg(test)]
mod tests;
mod totals;

pub use config::{LocalMapping, LockstepConfig};
pub use engine::Lockstep;
pub use error::LockstepError;
pub use field::FieldWidth;
pub use fixed_map::FixedMap;
pub use layers::Layers;
pub use mismatch::{Layer, Mismatch};
pub use ram::RamUse;
pub use storage::CoreStorage;
pub use totals::Totals;
