//! The rolling occupancy grid, exact distances of 16 bits, the nearest obstacle of a cell, and a ray.
#![no_std]
#![no_main]

use horus_core::distance::{DistanceMap, DistanceMapBuffers, DistanceOptions};
use horus_core::nalgebra::{Isometry2, UnitComplex, Vector2};
use horus_core::prelude::*;
use horus_core::raycast::{RayCaster, WalkRule};
use horus_footprint::{in_bss, need, opaque};

horus_footprint::start!(run);

type Distances = DistanceMapBuffers<u16, { 200 * 200 }, 200>;

fn run() {
    let grid = in_bss!(StaticOccupancyGrid<{ 200 * 200 }>, StaticOccupancyGrid::empty());
    need(grid.reset(200, 200, 0.05, opaque(Pose2D::new(-5.0, -5.0, 0.1))));
    let mut distances = DistanceMap::new_in(in_bss!(Distances, Distances::empty()).split());
    loop {
        need(grid.recenter(opaque(Pose2D::new(0.4, 0.7, 0.0))));
        need(grid.set_occupancy(opaque(3), opaque(4), opaque(100)));
        need(distances.compute(&*grid, opaque(DistanceOptions::default())));
        need(distances.squared_at(opaque(5), opaque(6)));
        need(distances.nearest_obstacle(&*grid, opaque(5), opaque(6)));
        let pose = opaque(Isometry2::new(Vector2::new(0.4, 0.7), 0.0));
        let rays = RayCaster::new(&*grid, pose, opaque(10.0), WalkRule::Standard);
        need(rays.cast(opaque(UnitComplex::identity())));
    }
}
