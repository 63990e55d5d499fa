//! Rays of 10 m through 200 x 200 cells of 5 cm, and what Beluga's requirements answer.

use horus_core::Error;
use horus_core::grid::{DenseGrid2, Frame, OccupancyGrid2d, RegularGrid};
use horus_core::nalgebra::{Isometry2, UnitComplex, Vector2};
use horus_core::prelude::*;
use horus_core::raycast::{RayCaster, WalkRule};
use horus_tests::meter::Stat;
use horus_tests::workload::RESOLUTION;

use crate::bench::Bench;

const SIDE: u32 = 200;
const SETTING: &str = "200x200 i8, free";
const RAYS: u32 = 36;

pub fn run(cells: &mut [i8], bench: &mut Bench<'_>) -> Result<(), Error> {
    let Bench { meter, table, .. } = bench;
    cells.fill(0);
    let grid = OccupancyGrid::view(cells, SIDE, SIDE, RESOLUTION, Pose2D::default())?;
    let corner = Isometry2::new(Vector2::new(0.31, 0.32), 0.0);
    let rules = [
        (WalkRule::Standard, "cast, standard, 10 m"),
        (WalkRule::Navground, "cast, navground, 10 m"),
        (WalkRule::Supercover, "cast, supercover, 10 m"),
    ];
    for (rule, name) in rules {
        let (rays, cost) = meter.measure(|| RayCaster::new(&grid, corner, 10.0, rule));
        if rule == WalkRule::Standard {
            table.row(SETTING, "RayCaster::new", cost);
        }
        let mut stat = Stat::default();
        for i in 0..RAYS {
            let bearing = UnitComplex::new(i as f32 * (core::f32::consts::FRAC_PI_2 / RAYS as f32));
            stat.add(meter.measure(|| rays.cast(bearing)).1);
        }
        table.row(SETTING, name, stat);
        let bearing = UnitComplex::new(0.4);
        let name = match rule {
            WalkRule::Standard => "trace, standard, 10 m",
            WalkRule::Navground => "trace, navground, 10 m",
            WalkRule::Supercover => "trace, supercover, 10 m",
        };
        table.row(SETTING, name, meter.measure(|| rays.trace(bearing).count()).1);
    }
    let mut row = |operation, cost| table.row(SETTING, operation, cost);
    row("free_cells", meter.measure(|| grid.free_cells().count()).1);
    row(
        "obstacle_edge_mask",
        meter
            .measure(|| grid.obstacle_edge_mask().filter(|edge| *edge).count())
            .1,
    );
    row("cell_near", meter.measure(|| grid.cell_near((1.0, 2.0))).1);
    row("free_near", meter.measure(|| grid.free_near((1.0, 2.0))).1);
    row("free_at, cell", meter.measure(|| grid.free_at((20, 30))).1);
    row(
        "coordinates_at, index, global",
        meter.measure(|| grid.coordinates_at(777_usize, Frame::Global)).1,
    );
    row(
        "neighborhood4, index",
        meter.measure(|| grid.neighborhood4(777_usize).count()).1,
    );
    Ok(())
}
