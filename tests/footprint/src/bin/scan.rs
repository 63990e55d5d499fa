//! The rolling occupancy grid with scan integration (`Set`).
#![no_std]
#![no_main]

use horus_core::prelude::*;
use horus_footprint::{in_bss, need, opaque, robot};

horus_footprint::start!(run);

fn run() {
    let grid = in_bss!(StaticOccupancyGrid<{ 200 * 200 }>, StaticOccupancyGrid::empty());
    let beams = in_bss!(ScanBuffers<360, 0>, ScanBuffers::empty());
    let ranges = opaque(in_bss!([f32; 360], [0.0; 360]));
    need(grid.reset(200, 200, 0.05, opaque(Pose2D::new(-5.0, -5.0, 0.1))));
    let mut workspace = beams.workspace();
    loop {
        let pose = opaque(Pose2D::new(0.4, 0.7, 0.0));
        need(grid.recenter(pose));
        need(grid.integrate_scan(&robot::scan(ranges), pose, ScanModel::Set, &mut workspace));
        need((grid.world_to_grid(opaque(1.0), 2.0), grid.occupancy(opaque(1), 2)));
    }
}
