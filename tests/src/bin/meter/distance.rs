//! Exact distances to the nearest obstacle of the office.

use horus_core::Error;
use horus_core::distance::{DistanceCell, DistanceMap, DistanceMapBuffers, DistanceOptions};
use horus_core::prelude::*;
use horus_tests::ZeroBits;
use horus_tests::workload::{Office, RESOLUTION};

use crate::bench::Bench;

/// Cells per side.
pub const SIDE: u32 = 128;
const CELLS: usize = (SIDE * SIDE) as usize;
/// A grid, and distances of one type.
pub type Storage<D> = ([i8; CELLS], DistanceMapBuffers<D, CELLS, { 2 * SIDE as usize }>);

pub fn run<D: DistanceCell>(
    setting: &'static str,
    (cells, buffers): &mut Storage<D>,
    bench: &mut Bench<'_>,
) -> Result<(), Error>
where
    Storage<D>: ZeroBits,
{
    let Bench {
        meter, table, office, ..
    } = bench;
    let mut row = |operation, cost| table.row(setting, operation, cost);
    let mut grid = OccupancyGrid::new_in(&mut cells[..], SIDE, SIDE, RESOLUTION, Pose2D::default())?;
    show(office, &mut grid);
    let (mut map, cost) = meter.measure(|| DistanceMap::new_in(buffers.split()));
    row("DistanceMap::new_in", cost);
    let near = DistanceOptions {
        max_squared: Some(20 * 20),
        ..DistanceOptions::default()
    };
    let all = DistanceOptions::default();
    let (done, cost) = meter.measure(|| map.compute(&grid, all));
    row("distances", cost);
    done?;
    row(
        "DistanceMap::squared_at",
        meter.measure(|| map.squared_at(60, 61)).1,
    );
    row(
        "DistanceMap::metres_at",
        meter.measure(|| map.metres_at(60, 61)).1,
    );
    row(
        "DistanceMap::nearest_obstacle",
        meter.measure(|| map.nearest_obstacle(&grid, 60, 61)).1,
    );
    let (done, cost) = meter.measure(|| map.compute(&grid, near));
    row("distances up to 20 cells", cost);
    done?;
    let window = CellRect {
        x0: 44,
        y0: 44,
        x1: 84,
        y1: 84,
    };
    let (done, cost) = meter.measure(|| map.compute_window(&grid, window, near));
    row("distances up to 20 cells, window of 40x40", cost);
    done
}

/// Makes a grid show the office, free or occupied everywhere.
pub fn show(office: &Office, grid: &mut OccupancyGrid<&mut [i8]>) {
    for gy in 0..grid.height() {
        for gx in 0..grid.width() {
            let blocked = office.is_blocked(gx as i32, gy as i32);
            grid.set_occupancy(gx, gy, if blocked { 100 } else { 0 });
        }
    }
}
