//! The local map: updates of a driving robot, and a cost map that follows.

use horus_core::Error;
use horus_core::costmap::bit_words;
use horus_core::prelude::*;
use horus_tests::meter::Stat;
use horus_tests::workload::{BEAMS, RESOLUTION, robot};

use crate::bench::Bench;
use crate::case;

const SIDE: u32 = 200;
pub const SETTING: &str = "200x200 local";
/// Updates; the first computes the beams' directions and is not counted.
const TICKS: u32 = 40;
/// Updates with a move by one cell along each axis.
const MOVES: i32 = 5;

/// Beams of a dense lidar.
const DENSE: usize = 3 * BEAMS;

/// The office's lidar, with so many beams over the same angles.
fn lidar(scan: &LaserScan<'_>, beams: usize) -> Lidar<'static> {
    Lidar {
        name: "lidar",
        mount: Pose2D::default(),
        start_angle: scan.angle_min,
        fov: scan.angle_increment * (BEAMS * (beams - 1) / beams) as f32,
        max_range: scan.range_max,
    }
}

fn config<'l>(side: u32, lidars: &'l [Lidar<'l>]) -> LocalGridMapConfig<'l> {
    LocalGridMapConfig {
        width: side,
        height: side,
        resolution: RESOLUTION,
        radius: 0.2,
        lidars,
        ..LocalGridMapConfig::default()
    }
}

/// Named buffers of one lidar.
pub type State = SensingBuffers<5, { BEAMS + 6 }, 0>;

pub fn run((cells, buffers): (&mut [u8; 200 * 200], &mut State), bench: &mut Bench<'_>) -> Result<(), Error> {
    let Bench {
        meter,
        table,
        beams,
        lidar: sensor,
        office,
        ..
    } = bench;
    let scan = sensor.measure(office, 0);
    let lidars = [lidar(&scan, BEAMS)];
    let mut map = None;
    let (done, cost) = meter
        .measure(|| LocalGridMap::new_in(&mut cells[..], config(SIDE, &lidars)).map(|made| map = Some(made)));
    table.row(SETTING, "LocalGridMap::new_in", cost);
    done?;
    let Some(mut map) = map else { return Ok(()) };
    let [lidar] = lidars;
    let mut state = buffers.state();
    lidar.prepare(&mut state, BEAMS)?;
    let mut workspaces = [beams.workspace()];

    let (mut write, mut update) = (Stat::default(), Stat::default());
    for tick in 0..TICKS {
        let scan = sensor.measure(office, tick);
        let (done, cost) = meter.measure(|| lidar.write(&mut state, scan.ranges));
        done?;
        write.add(cost);
        let (done, cost) = meter.measure(|| map.update(&state, robot(tick), &mut workspaces));
        done?;
        if tick > 0 {
            update.add(cost);
        } else {
            table.row(SETTING, "update, far, beam directions included", cost);
        }
    }
    table.row(SETTING, "Lidar::write", write);
    table.row(SETTING, "update, moving", update);

    for (axis, name) in [
        ([1, 0], "update, one cell in x"),
        ([0, 1], "update, one cell in y"),
    ] {
        let mut update = Stat::default();
        for direction in [1, -1] {
            for _ in 0..MOVES {
                let by = axis.map(|axis: i32| axis * direction);
                let [x, y] = map.origin();
                let centre = |corner: f32, by: i32| corner + (SIDE as f32 * 0.5 + by as f32) * RESOLUTION;
                let pose = Pose2D::new(centre(x, by[0]), centre(y, by[1]), 0.1);
                let (done, cost) = meter.measure(|| map.update(&state, pose, &mut workspaces));
                assert_eq!(done?.shift, by);
                update.add(cost);
            }
        }
        table.row(SETTING, name, update);
    }
    let pose = map.origin().map(|corner| corner + SIDE as f32 * 0.5 * RESOLUTION);
    let pose = Pose2D::new(pose[0], pose[1], 0.1);
    let (done, cost) = meter.measure(|| map.update(&state, pose, &mut workspaces));
    assert_eq!(done?.shift, [0, 0]);
    table.row(SETTING, "update, standing", cost);
    Ok(())
}

/// Cells per side of a local map that a cost map follows: both fit.
const FOLLOWED_SIDE: u32 = 120;
const FOLLOWED: &str = "120x120 local, R 11";
const FOLLOWED_CELLS: usize = (FOLLOWED_SIDE * FOLLOWED_SIDE) as usize;

/// A local map and the cost map that follows it.
pub type Following = (
    ([u8; FOLLOWED_CELLS], State),
    CostMapBuffers<FOLLOWED_CELLS, { bit_words(FOLLOWED_SIDE, FOLLOWED_SIDE) }>,
);

pub fn run_followed(memory: &mut Following, bench: &mut Bench<'_>) -> Result<(), Error> {
    let Bench {
        meter,
        table,
        beams,
        lidar: sensor,
        office,
        ..
    } = bench;
    let ((cells, state), costs) = memory;
    let scan = sensor.measure(office, 0);
    let lidars = [lidar(&scan, BEAMS)];
    let mut map = LocalGridMap::new_in(&mut cells[..], config(FOLLOWED_SIDE, &lidars))?;
    let (cells, buffers) = costs.split();
    let grid = OccupancyGrid::new_in(cells, FOLLOWED_SIDE, FOLLOWED_SIDE, RESOLUTION, Pose2D::default())?;
    let mut costs = CostMap::new_in(grid, buffers, case::R11.params)?;
    let mut state = state.state();
    let mut workspaces = [beams.workspace()];

    let (mut follow, mut update) = (Stat::default(), Stat::default());
    for tick in 0..TICKS {
        let scan = sensor.measure(office, tick);
        lidars[0].write(&mut state, scan.ranges)?;
        map.update(&state, robot(tick), &mut workspaces)?;
        let (done, follows) = meter.measure(|| map.update_cost_map(&mut costs));
        done?;
        let (_, updates) = meter.measure(|| costs.update_costs());
        if tick > 0 {
            follow.add(follows);
            update.add(updates);
        }
    }
    table.row(FOLLOWED, "update_cost_map, moving", follow);
    table.row(FOLLOWED, "update_costs after it", update);
    Ok(())
}

/// A local map of a dense lidar.
pub type Dense = (
    ([u8; 200 * 200], SensingBuffers<5, { DENSE + 6 }, 0>),
    (ScanBuffers<DENSE, 0>, [f32; DENSE]),
);

pub fn run_dense(memory: &mut Dense, bench: &mut Bench<'_>) -> Result<(), Error> {
    let Bench {
        meter,
        table,
        lidar: sensor,
        office,
        ..
    } = bench;
    let ((cells, state), (beams, ranges)) = memory;
    let lidars = [lidar(&sensor.measure(office, 0), DENSE)];
    let mut map = LocalGridMap::new_in(&mut cells[..], config(SIDE, &lidars))?;
    let mut state = state.state();
    let mut workspaces = [beams.workspace()];
    let mut update = Stat::default();
    for tick in 0..TICKS {
        let scan = sensor.measure(office, tick);
        for (three, range) in ranges.chunks_mut(DENSE / BEAMS).zip(scan.ranges) {
            three.fill(*range);
        }
        lidars[0].write(&mut state, ranges)?;
        let (done, cost) = meter.measure(|| map.update(&state, robot(tick), &mut workspaces));
        done?;
        if tick > 0 {
            update.add(cost);
        }
    }
    table.row(SETTING, "update, moving, 1080 rays", update);
    Ok(())
}
