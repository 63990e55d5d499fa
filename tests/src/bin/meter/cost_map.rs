//! Cost maps: full and incremental, scans, window shifts, look-ups.

use horus_core::Error;
use horus_core::costmap::FieldCell;
use horus_core::prelude::*;
use horus_tests::meter::{Meter, Stat, Table};
use horus_tests::rt::hprintln;
use horus_tests::workload::{CENTRE, Lidar, Office, RESOLUTION, Random, robot};

use crate::bench::Bench;
use crate::case::Case;

/// Single cells in and out.
const EDITS: u32 = 50;
/// Scans; the first, which adds range noise to a clean map, is not counted.
const SCANS: u32 = 40;
/// Accumulating scans after them.
const ACCUMULATED: u32 = 10;
/// Moves of the window along each axis, there and back.
const MOVES: i32 = 5;

pub fn run<F: FieldCell>(
    case: &Case,
    (cells, buffers): (&mut [i8], CostBuffers<'_, F>),
    bench: &mut Bench<'_>,
) -> Result<(), Error> {
    let Bench {
        meter, table, office, ..
    } = bench;
    // All of the building if it fits, else the part around the robot's room.
    let side = case.side as i32;
    let corner = (CENTRE - side / 2).min(Office::SIDE - side) as f32;
    let grid = case.grid(cells, (corner, corner))?;

    let mut map = None;
    let (done, cost) =
        meter.measure(|| CostMap::new_in(grid, buffers, case.params).map(|made| map = Some(made)));
    table.row(case.setting, "CostMap::new_in", cost);
    done?;
    let Some(mut map) = map else { return Ok(()) };
    case.show(office, &mut map);
    let (done, cost) = meter.measure(|| map.set_params(case.params));
    table.row(case.setting, "set_params", cost);
    done?;
    let ((), cost) = meter.measure(|| map.compute_costs());
    table.row(case.setting, "compute_costs", cost);

    edits(case, &mut map, meter, table);
    scans(case, &mut map, bench)?;
    let Bench { meter, table, .. } = bench;
    moves(case, &mut map, meter, table)?;
    look_ups(case, &map, meter, table);
    Ok(())
}

/// Single free cells become occupied, and free again.
fn edits<F: FieldCell>(case: &Case, map: &mut CostMap<'_, F>, meter: &Meter, table: &mut Table) {
    let mut random = Random::new(5);
    let (mut inserted, mut removed) = (Stat::default(), Stat::default());
    let mut edits = 0;
    while edits < EDITS {
        let mut inner = || (30 + random.below(case.side as i32 - 60)) as u32;
        let (gx, gy) = (inner(), inner());
        if map.occupancy_grid().occupancy(gx, gy) != Some(0) {
            continue;
        }
        edits += 1;
        for (value, stat) in [(100, &mut inserted), (0, &mut removed)] {
            map.set_occupancy(gx, gy, value);
            stat.add(meter.measure(|| map.update_costs()).1);
        }
    }
    table.row(case.setting, "update_costs, one cell in", inserted);
    table.row(case.setting, "update_costs, one cell out", removed);
    let (_, cost) = meter.measure(|| map.update_costs());
    table.row(case.setting, "update_costs, nothing changed", cost);
}

/// What a lidar sees from a robot on its circle.
fn scans<F: FieldCell>(case: &Case, map: &mut CostMap<'_, F>, bench: &mut Bench<'_>) -> Result<(), Error> {
    let Bench {
        meter,
        table,
        office,
        lidar,
        beams,
        occupied,
    } = bench;
    let mut workspace = beams.workspace();
    **lidar = Lidar::new();
    occupied.follow(map.occupancy_grid());
    let (mut rays, mut update, mut changes) = (Stat::default(), Stat::default(), 0);
    for tick in 0..SCANS {
        let (scan, pose) = (lidar.measure(office, tick), robot(tick));
        let (done, cost) = meter.measure(|| map.integrate_scan(&scan, pose, ScanModel::Set, &mut workspace));
        done?;
        let changed = occupied.follow(map.occupancy_grid());
        let (_, updated) = meter.measure(|| map.update_costs());
        if tick > 0 {
            rays.add(cost);
            update.add(updated);
            changes += changed;
        }
    }
    table.row(case.setting, "integrate_scan, set", rays);
    table.row(case.setting, "update_costs, 360-beam scan", update);
    hprintln!(
        "# {}: net changes per scan: {}",
        case.setting,
        changes / (SCANS - 1)
    );

    let (mut rays, mut update, mut part) = (Stat::default(), Stat::default(), Stat::default());
    for tick in SCANS..SCANS + ACCUMULATED {
        let (scan, pose) = (lidar.measure(office, tick), robot(tick));
        let model = ScanModel::accumulate();
        let (done, cost) = meter.measure(|| map.integrate_scan(&scan, pose, model, &mut workspace));
        done?;
        rays.add(cost);
        update.add(meter.measure(|| map.update_costs()).1);
    }
    table.row(case.setting, "integrate_scan, accumulate", rays);
    table.row(case.setting, "update_costs, accumulated scan", update);

    let tick = SCANS + ACCUMULATED;
    let scan = lidar.measure(office, tick);
    map.integrate_scan(&scan, robot(tick), ScanModel::Set, &mut workspace)?;
    let budget = map.min_budget();
    let mut pending = 1;
    while pending > 0 {
        let (done, cost) = meter.measure(|| map.update_costs_within(budget));
        pending = done?.pending;
        part.add(cost);
    }
    table.row(case.setting, "update_costs_within(min_budget), one call", part);
    Ok(())
}

/// The window moves by single cells.
fn moves<F: FieldCell>(
    case: &Case,
    map: &mut CostMap<'_, F>,
    meter: &Meter,
    table: &mut Table,
) -> Result<(), Error> {
    for (axis, name, updated) in [
        ([1, 0], "recenter, one cell in x", "update_costs, after that in x"),
        ([0, 1], "recenter, one cell in y", "update_costs, after that in y"),
    ] {
        let (mut shift, mut update) = (Stat::default(), Stat::default());
        for direction in [1, -1] {
            for _ in 0..MOVES {
                let by = axis.map(|axis: i32| axis * direction);
                let origin = map.info().origin();
                let centre =
                    |corner: f32, by: i32| corner + (case.side as f32 * 0.5 + by as f32) * RESOLUTION;
                let pose = Pose2D::new(centre(origin.x, by[0]), centre(origin.y, by[1]), 0.0);
                let (moved, cost) = meter.measure(|| map.recenter(pose));
                assert_eq!(moved?, by);
                shift.add(cost);
                update.add(meter.measure(|| map.update_costs()).1);
            }
        }
        table.row(case.setting, name, shift);
        table.row(case.setting, updated, update);
    }
    Ok(())
}

fn look_ups<F: FieldCell>(case: &Case, map: &CostMap<'_, F>, meter: &Meter, table: &mut Table) {
    let mut row = |operation, cost| table.row(case.setting, operation, cost);
    let (pose, middle) = (robot(0), case.side / 2);
    row("cost", meter.measure(|| map.cost(pose.x, pose.y)).1);
    row("cost_at", meter.measure(|| map.cost_at(middle, middle)).1);
    row("row, all of it", meter.measure(|| map.row(middle).max()).1);
    let outline = [(0.3, 0.2), (-0.3, 0.2), (-0.3, -0.2), (0.3, -0.2)];
    row(
        "footprint_cost, 0.6 m x 0.4 m",
        meter.measure(|| map.footprint_cost(pose, &outline)).1,
    );
}
