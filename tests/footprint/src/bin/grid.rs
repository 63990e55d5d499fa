//! The rolling occupancy grid: made, moved, written, read.
#![no_std]
#![no_main]

use horus_core::prelude::*;
use horus_footprint::{in_bss, need, opaque};

horus_footprint::start!(run);

fn run() {
    let grid = in_bss!(StaticOccupancyGrid<{ 200 * 200 }>, StaticOccupancyGrid::empty());
    need(grid.reset(200, 200, 0.05, opaque(Pose2D::new(-5.0, -5.0, 0.1))));
    loop {
        need(grid.recenter(opaque(Pose2D::new(0.4, 0.7, 0.0))));
        need(grid.set_occupancy(opaque(3), opaque(4), opaque(100)));
        need((grid.world_to_grid(opaque(1.0), 2.0), grid.occupancy(opaque(1), 2)));
    }
}
