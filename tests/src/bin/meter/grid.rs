//! The occupancy grid on its own.

use horus_core::Error;
use horus_core::prelude::*;
use horus_tests::workload::{RESOLUTION, robot};

use crate::bench::Bench;

const SIDE: u32 = 200;
const SETTING: &str = "200x200 i8";

pub fn run(cells: &mut [i8], bench: &mut Bench<'_>) -> Result<(), Error> {
    let Bench {
        meter,
        table,
        beams,
        lidar,
        office,
        ..
    } = bench;
    let mut row = |operation, cost| table.row(SETTING, operation, cost);
    let origin = Pose2D::new(0.0, 0.0, 0.1);

    let mut grid = None;
    let (done, cost) = meter.measure(|| {
        OccupancyGrid::new_in(cells, SIDE, SIDE, RESOLUTION, origin).map(|made| grid = Some(made))
    });
    row("OccupancyGrid::new_in", cost);
    done?;
    let Some(mut grid) = grid else { return Ok(()) };
    let (done, cost) = meter.measure(|| grid.reset(SIDE, SIDE, RESOLUTION, origin));
    row("OccupancyGrid::reset", cost);
    done?;
    let (mut workspace, cost) = meter.measure(|| beams.workspace());
    row("ScanBuffers::workspace", cost);

    let (x, y) = (4.0, 5.0);
    row("world_to_grid", meter.measure(|| grid.world_to_grid(x, y)).1);
    row("grid_to_world", meter.measure(|| grid.grid_to_world(80, 90)).1);
    row("is_free", meter.measure(|| grid.is_free(x, y)).1);
    row("occupancy", meter.measure(|| grid.occupancy(80, 90)).1);
    row(
        "set_occupancy",
        meter.measure(|| grid.set_occupancy(80, 90, 100)).1,
    );
    row("set_frame_id", meter.measure(|| grid.set_frame_id("map")).1);

    let (scan, pose) = (lidar.measure(office, 0), robot(0));
    let (done, cost) = meter.measure(|| grid.integrate_scan(&scan, pose, ScanModel::Set, &mut workspace));
    row("integrate_scan, beam directions included", cost);
    done?;
    let (done, cost) = meter.measure(|| grid.recenter(pose));
    row("recenter, far", cost);
    done?;
    Ok(())
}
