//! The drive that `tests/c/digest.c` repeats through the C interface: the same lines.
//!
//! All input comes from integers and single multiplications, so that both languages feed the same
//! bits; the two texts follow each other function by function.

use horus_core::costmap::FieldCell;
use horus_core::prelude::*;

use crate::hash::Hash;
use crate::made_up::{metres, next};
use crate::report::Line;

/// Columns of every map.
pub const WIDTH: u32 = 120;
/// Rows of every map.
pub const HEIGHT: u32 = 80;
/// Beams of the lidar.
pub const BEAMS: usize = 120;
const TICKS: u32 = 32;

/// Storage of the kept costs. Everything else fits into the other drives' buffers.
pub type Costs = [u8; (WIDTH * HEIGHT) as usize];

/// How one drive differs from the others.
#[derive(Clone, Copy, Debug)]
pub struct Scenario {
    /// Its name in the report.
    pub name: &'static str,
    /// Parameters of the cost map.
    pub params: CostParams,
    /// How scans change cells.
    pub model: ScanModel,
    /// Budget of an update above the smallest, in cell visits; `None`: unlimited.
    pub budget: Option<u32>,
}

/// Everything at once, with a one-byte field.
pub fn direct() -> Scenario {
    Scenario {
        name: "c: one byte",
        params: CostParams::nav2(),
        model: ScanModel::Set,
        budget: None,
    }
}

/// Accumulating, a little per tick, with a one-byte field and kept costs.
pub fn budgeted() -> Scenario {
    Scenario {
        name: "c: one byte, kept, budgeted",
        params: CostParams::horus(),
        model: ScanModel::accumulate(),
        budget: Some(900),
    }
}

/// Far-reaching costs in a two-byte field, kept.
pub fn far() -> Scenario {
    let params = CostParams {
        inflation_radius: 1.0,
        cost_scaling_factor: 2.0,
        ..CostParams::nav2()
    };
    Scenario {
        name: "c: two bytes, kept",
        params,
        model: ScanModel::Set,
        budget: None,
    }
}

fn pose_at(tick: i32) -> Pose2D {
    let jump = if tick == 20 { 30_000 } else { 0 }; // out of the window and back
    Pose2D::new(
        metres(37 * tick - 300 + jump),
        metres(21 * tick - 300),
        metres(110 * tick),
    )
}

fn measure(noise: &mut u32, tick: i32, ranges: &mut [f32; BEAMS]) {
    for (i, range) in (0..).zip(ranges) {
        let n = next(noise);
        *range = match n % 61 {
            0 => f32::NAN,
            1 => f32::NEG_INFINITY,
            2 => f32::INFINITY,
            3 => metres(10),
            _ => metres(900 + (29 * i + 13 * tick) % 1700 + (n % 40) as i32),
        };
    }
}

fn hash_rect(hash: &mut Hash, rect: Option<CellRect>) {
    let none = CellRect {
        x0: 0,
        y0: 0,
        x1: 0,
        y1: 0,
    };
    let CellRect { x0, y0, x1, y1 } = rect.unwrap_or(none);
    [x0, y0, x1, y1].into_iter().for_each(|v| hash.word(v));
}

/// One tick: the window follows, a scan and a few edits come in, the costs are brought up to date.
fn step<F: FieldCell>(
    map: &mut CostMap<'_, F>,
    lidar: &mut ScanWorkspace<'_>,
    scenario: &Scenario,
    tick: i32,
    noise: &mut u32,
    calls: &mut Hash,
) -> Result<(), Error> {
    let pose = pose_at(tick);
    let mut ranges = [0.0; BEAMS];
    measure(noise, tick, &mut ranges);
    for by in map.recenter(pose)? {
        calls.word(by as u32);
    }
    let scan = LaserScan {
        angle_min: -3.0,
        angle_increment: 0.05,
        range_min: 0.1,
        range_max: 4.0,
        ranges: &ranges,
    };
    let report = map.integrate_scan(&scan, pose, scenario.model, lidar)?;
    hash_rect(calls, report.changed);
    [report.hits, report.misses, report.ignored]
        .into_iter()
        .for_each(|v| calls.word(v));
    for _ in 0..20 {
        let (gx, gy) = (next(noise) % (WIDTH + 4), next(noise) % (HEIGHT + 4));
        let value = (next(noise) % 140) as i32 - 20;
        calls.byte(map.set_occupancy(gx, gy, value as i8).into());
    }
    if tick == 16 {
        map.set_params(scenario.params.with_radius(0.4))?;
    }
    let changed = match scenario.budget {
        None => map.update_costs(),
        Some(extra) => {
            let update = map.update_costs_within(map.min_budget() + extra)?;
            [update.pending, map.calls_left()]
                .into_iter()
                .for_each(|v| calls.word(v));
            update.changed
        }
    };
    // Without kept costs the rectangle may hold more than changed, and how much more is the kernel's.
    if map.costs().is_some() {
        hash_rect(calls, changed);
    }
    Ok(())
}

/// What a planner asks around the robot.
fn hash_reads<F: FieldCell>(hash: &mut Hash, map: &CostMap<'_, F>, tick: i32) -> Result<(), Error> {
    let pose = pose_at(tick);
    let grid = map.occupancy_grid();
    for i in -8..8 {
        let (x, y) = (pose.x + metres(470 * i), pose.y);
        hash.word(map.cost(x, y).map_or(256, u32::from));
        hash.byte(grid.is_free(x, y).into());
        hash.byte(grid.is_occupied(x, y).into());
        if let Some((gx, gy)) = grid.world_to_grid(x, y) {
            let (x, y) = grid.grid_to_world(gx, gy).unwrap_or_default();
            [gx, gy, x.to_bits(), y.to_bits()]
                .into_iter()
                .for_each(|v| hash.word(v));
        }
    }
    let outline = [
        (0.4f32, 0.3f32),
        (-0.4, 0.3),
        (-0.4, -0.3),
        (0.4, -0.3),
        (0.6, 0.0),
    ];
    let under = map.footprint_cost(pose, &outline)?;
    hash.word(under.cost.map_or(u32::MAX, u32::from));
    hash.byte(under.touches_unknown.into());
    hash.byte(under.leaves_map.into());
    Ok(())
}

fn hash_costs<F: FieldCell>(hash: &mut Hash, map: &CostMap<'_, F>) {
    (0..HEIGHT).for_each(|gy| map.row(gy).for_each(|cost| hash.byte(cost)));
    map.costs()
        .unwrap_or_default()
        .iter()
        .for_each(|cost| hash.byte(*cost));
}

/// Drives once and shows every line of the report.
pub fn run<F: FieldCell>(
    scenario: &Scenario,
    (cells, buffers): (&mut [i8], CostBuffers<'_, F>),
    lidar: &mut ScanWorkspace<'_>,
    mut show: impl FnMut(Line),
) -> Result<(), Error> {
    let origin = Pose2D::new(-3.0, -2.0, 0.25);
    let grid = OccupancyGrid::new_in(cells, WIDTH, HEIGHT, 0.05, origin)?;
    let mut map = CostMap::new_in(grid, buffers, scenario.params)?;
    let mut noise = 0x2545_f491;
    let mut calls = Hash::default();
    for tick in 0..TICKS {
        step(&mut map, lidar, scenario, tick as i32, &mut noise, &mut calls)?;
        if tick % 8 != 7 {
            continue;
        }
        if tick == TICKS - 1 {
            calls.word(map.min_budget());
            while map.pending() > 0 {
                let update = map.update_costs_within(map.min_budget())?;
                calls.word(update.pending);
            }
        }
        let mut line = |stage, hash| {
            show(Line {
                scenario: scenario.name,
                tick,
                stage,
                hash,
            });
        };
        hash_reads(&mut calls, &map, tick as i32)?;
        line("calls", calls);
        let mut cells = Hash::default();
        map.occupancy_grid()
            .data()
            .iter()
            .for_each(|v| cells.byte(*v as u8));
        line("cells", cells);
        let mut costs = Hash::default();
        hash_costs(&mut costs, &map);
        line("costs", costs);
    }
    Ok(())
}
