//! The functions as C calls them, on memory of exactly the length they ask for. Small enough for
//! miri, which sees every invalid pointer: `tests/c/README.md` has the command.
//!
//! The C programs in `tests/c` go through the same calls on large maps.

extern crate std;

mod cost_map;
mod distance;
mod evidence;
mod grid;
mod local_map;
mod memory;
mod refusals;

use super::*;
use memory::Memory;

use super::horus_status as Status;
use crate::geometry::{CellRect, Pose2D};

const HOME: Pose2D = Pose2D::new(0.0, 0.0, 0.0);

fn grid_config(width: u32, height: u32) -> horus_grid_config {
    horus_grid_config {
        width,
        height,
        resolution: 0.1,
        origin: HOME,
    }
}

fn map_config(width: u32, height: u32, field_bytes: u8, keep_costs: u8) -> horus_cost_map_config {
    horus_cost_map_config {
        grid: grid_config(width, height),
        params: horus_cost_params_default(),
        field_bytes,
        keep_costs,
    }
}

fn scan_of(ranges: &[f32]) -> horus_laser_scan {
    horus_laser_scan {
        ranges: ranges.as_ptr(),
        count: ranges.len(),
        angle_min: 0.0,
        angle_increment: 0.4,
        range_min: 0.05,
        range_max: 3.0,
    }
}
