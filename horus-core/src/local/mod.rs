//! A rolling local map from lidar scans and optional odometry: the simplest perception of a small
//! robot, bit for bit that of navground's `LocalGridMap`.
//!
//! Sensors write into a [`SensingState`], a fixed-capacity store of named buffers: a [`Lidar`] its
//! scan, an [`Odometry`] its pose. [`LocalGridMap::update`] recentres the map on the robot, frees
//! the cells under its [`Footprint`], and draws every lidar's scan: first all its free rays, then
//! all its marks. Cells are bytes: [`OCCUPIED`], [`UNKNOWN`], [`FREE`]. The map is aligned with the
//! odometry frame and never rotates.
//!
//! A cost map follows the local map through [`LocalGridMap::update_cost_map`].
//!
//! Source: navground 0.7.0 `LocalGridMapStateEstimation`, except where its page or this one says
//! otherwise: a far move leaves no stale cells, the window's place is counted in whole cells, lidars
//! have mounting poses, the transformation holds for turned odometry frames, and invalid values are
//! errors.

use crate::grid::LocalMapValues;

mod config;
mod cost_map;
mod footprint;
mod frame;
mod lidar;
mod map;
mod odometry;
mod output;
mod property;
mod rays;
mod requirements;
mod state;
mod update;

pub use config::LocalGridMapConfig;
#[cfg(feature = "c-abi")]
pub(crate) use cost_map::{Follower, follow};
pub use footprint::Footprint;
pub use lidar::Lidar;
pub use map::LocalGridMap;
pub use odometry::Odometry;
pub use output::GridMapView;
pub use property::{Property, PropertyKind, PropertyValue};
pub use state::{BufferSlot, BufferView, Element, ElementKind, SensingBuffers, SensingState, Shape};
pub use update::{LocalUpdate, PoseSource};

/// Cell value: an obstacle.
pub const OCCUPIED: u8 = LocalMapValues::OCCUPIED;
/// Cell value: nothing is known.
pub const UNKNOWN: u8 = LocalMapValues::UNKNOWN;
/// Cell value: free.
pub const FREE: u8 = LocalMapValues::FREE;

/// Bytes that a sensor's or a map's name may have.
pub const MAX_NAME: usize = crate::error::MAX_NAME;
