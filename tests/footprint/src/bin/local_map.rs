//! A local map with one lidar and odometry, and beside it the cost map of `cost_map`, which takes the
//! scans itself and does not follow the local map.
#![no_std]
#![no_main]

use horus_core::prelude::*;
use horus_footprint::{in_bss, need, opaque, robot};

horus_footprint::start!(run);
horus_footprint::run_cost_map!(drive, 160, u8, 512, 0);

/// Names of one lidar and of odometry.
type State = SensingBuffers<7, { 360 + 12 }, 0>;

fn drive(
    (cells, buffers): (&mut [i8], CostBuffers<'_, u8>),
    workspace: &mut ScanWorkspace<'_>,
    ranges: &[f32],
    side: u32,
) -> Result<(), Error> {
    let mut costs = robot::map(cells, buffers, side)?;
    let front = Lidar {
        name: "front",
        mount: opaque(Pose2D::new(0.1, 0.0, 0.0)),
        start_angle: opaque(-2.0),
        fov: opaque(4.0),
        max_range: opaque(8.0),
    };
    let odometry = Odometry { name: "odom" };
    let config = LocalGridMapConfig {
        width: opaque(200),
        height: opaque(200),
        resolution: 0.05,
        radius: opaque(0.2),
        footprint: Footprint::Circular,
        external_odometry: odometry.name,
        lidars: &[front],
        ..LocalGridMapConfig::default()
    };
    let local_cells = in_bss!([u8; 200 * 200], [0; 200 * 200]);
    let mut local = LocalGridMap::new_in(&mut local_cells[..], config)?;
    let mut state = in_bss!(State, State::empty()).state();
    let mut lidars = [in_bss!(ScanBuffers<360, 0>, ScanBuffers::empty()).workspace()];
    loop {
        front.write(&mut state, ranges)?;
        odometry.write(&mut state, opaque(Pose2D::new(0.4, 0.7, 0.1)), [0.0; 3])?;
        need(local.update(&state, opaque(Pose2D::default()), &mut lidars)?);
        need((local.value(opaque(1), 2), local.value_at(opaque(1.0), 2.0)));
        robot::tick(&mut costs, workspace, ranges)?;
    }
}
