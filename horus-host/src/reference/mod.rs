//! The std version of the occupancy grid, the cost map, distances and rays, and the oracle `horus-core` is tested against.
//!
//! Everything here is written to be read, not to be fast: `Vec`s, no tables, no distance field, no state carried from
//! one call to the next, and nothing shared with `horus-core`. There are two kinds of arithmetic:
//!
//! - **Decisions**, that is which cell a beam ends in, how far a window shifts and every cost byte, are f32 with a
//!   fixed order of operations ([`OccupancyGrid::integrate_scan`], [`OccupancyGrid::recenter`], [`BelugaGrid::trace`],
//!   [`CostMap::compute_costs`], [`CostMap::footprint_cost`]). Another implementation must agree on every byte.
//! - **Point queries** take and return f64 metres ([`OccupancyGrid::world_to_grid`] and what builds on it) and agree
//!   with an f32 implementation on every point farther than 2e-3 cell from a cell boundary, and on every nominal
//!   boundary.
//!
//! World coordinates are metres in the frame named by `frame_id`, x forward, y left, angles in radians
//! counter-clockwise. Grids are row-major with row 0 at the lowest y, and a grid's origin is the pose of the outer
//! corner of cell (0, 0): `world = origin * local`, heading included.
//!
//! # Examples
//! ```
//! use horus_host::prelude::*;
//!
//! // Create a 10m x 10m map at 5cm resolution
//! let origin = Pose2D::new(-5.0, -5.0, 0.0);
//! let mut grid = OccupancyGrid::new(200, 200, 0.05, origin);
//!
//! // Mark a cell as occupied
//! grid.set_occupancy(100, 100, 100);
//!
//! // Convert between world and grid coordinates
//! let (gx, gy) = grid.world_to_grid(1.5, 2.0).unwrap();
//! let (wx, wy) = grid.grid_to_world(gx, gy).unwrap();
//!
//! // Query occupancy
//! if grid.is_free(1.5, 2.0) {
//!     println!("Path is clear");
//! }
//! # assert_eq!((gx, gy), (130, 140));
//! # assert!((wx - 1.525).abs() < 1e-6 && (wy - 2.025).abs() < 1e-6);
//! # // A fresh grid is unknown, so nothing but the marked cell is known to be anything.
//! # assert!(!grid.is_free(1.5, 2.0) && !grid.is_occupied(1.5, 2.0));
//! # assert!(grid.is_occupied(0.025, 0.025));
//!
//! // Create a cost map for path planning
//! let costmap = CostMap::from_occupancy_grid(grid, 0.55); // 55cm inflation
//! let cost = costmap.cost(1.5, 2.0);
//! # assert_eq!(cost, Some(255));
//! # assert_eq!(costmap.cost(0.025, 0.025), Some(253));
//! # assert_eq!(costmap.cost(7.0, 0.0), None);
//! ```

mod cell_walk;
mod cost_map;
mod cost_params;
mod decay;
mod distance;
mod error;
pub mod evidence;
mod footprint;
mod frame;
mod grid;
mod inflation;
mod integrate;
mod laser_scan;
mod local;
mod pose;
mod raycast;
mod rect;
mod requirements;
mod scan_model;
mod scan_report;
mod walk;
mod window;

pub use cell_walk::{standard_walk, supercover_walk};
pub use cost_map::CostMap;
pub use cost_params::CostParams;
pub use decay::Decay;
pub use distance::{signed_squared_distances, squared_distances};
pub use error::ReferenceError;
pub use footprint::FootprintCost;
pub use grid::OccupancyGrid;
#[doc(hidden)]
pub use inflation::inflate;
pub use laser_scan::LaserScan;
pub use local::{
    LidarScan, LocalFootprint, LocalGridMap, LocalGridMapConfig, LocalUpdate, SensingBuffer, SensingState,
};
pub use pose::Pose2D;
pub use raycast::Walk;
pub use rect::Rect;
pub use requirements::{BelugaGrid, Values};
pub use scan_model::ScanModel;
pub use scan_report::ScanReport;
pub use walk::{walk_cell, walk_inside, walk_steps};

#[cfg(test)]
mod tests;
