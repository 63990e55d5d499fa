//! The local map's drive, which `tests/c/local.c` repeats through the C interface: the same lines.
//!
//! All input comes from integers and single multiplications, as in [`c_drive`](crate::c_drive).

use horus_core::prelude::*;

use crate::hash::Hash;
use crate::made_up::{metres, next};
use crate::report::Line;

/// Columns.
pub const WIDTH: u32 = 90;
/// Rows.
pub const HEIGHT: u32 = 70;
/// Most beams of a lidar.
pub const BEAMS: usize = 120;
const TICKS: u32 = 32;
const RESOLUTION: f32 = 0.05;

/// Cells of the map.
pub const CELLS: usize = (WIDTH * HEIGHT) as usize;
/// Named buffers: two lidars, an odometry, and what the map publishes.
pub const SLOTS: usize = 16;
/// Numbers in them.
pub const FLOATS: usize = 2 * (BEAMS + 6) + 12;

/// How one drive differs from the others.
#[derive(Clone, Copy, Debug)]
pub struct Scenario {
    /// Its name in the report.
    pub name: &'static str,
    /// What is freed around the robot.
    pub footprint: Footprint,
    /// Radius of that in metres.
    pub radius: f32,
}

/// All drives.
pub const SCENARIOS: [Scenario; 3] = [
    Scenario {
        name: "c: local, square",
        footprint: Footprint::Rectangular,
        radius: 0.93,
    },
    Scenario {
        name: "c: local, disc",
        footprint: Footprint::Circular,
        radius: 1.11,
    },
    Scenario {
        name: "c: local, no footprint",
        footprint: Footprint::None,
        radius: 0.0,
    },
];

fn pose_at(tick: i32) -> Pose2D {
    let jump = if tick == 20 { 30_000 } else { 0 }; // out of the window and back
    Pose2D::new(
        metres(37 * tick - 300 + jump),
        metres(21 * tick - 300),
        metres(110 * tick),
    )
}

fn measure(noise: &mut u32, tick: i32, ranges: &mut [f32]) {
    for (i, range) in (0..).zip(ranges) {
        let n = next(noise);
        *range = match n % 61 {
            0 => f32::NAN,
            1 => f32::NEG_INFINITY,
            2 => f32::INFINITY,
            3 => metres(10),
            4 => metres(-200),
            _ => metres(700 + (29 * i + 13 * tick) % 1900 + (n % 40) as i32),
        };
    }
}

/// The lidars: one ahead on the robot, one at its back that sees backwards.
const LIDARS: [Lidar<'static>; 2] = [
    Lidar {
        name: "front",
        mount: Pose2D::new(0.15, 0.0, 0.0),
        start_angle: -3.0,
        fov: 6.0,
        max_range: 2.5,
    },
    Lidar {
        name: "rear",
        mount: Pose2D::new(-0.125, 0.03, 3.0),
        start_angle: -1.0,
        fov: 2.0,
        max_range: 1.75,
    },
];

/// Drives once and shows every line of the report.
/// The storage: [`CELLS`] cells; a state with [`SLOTS`] slots, [`FLOATS`] floats and a byte per
/// cell; two workspaces of [`BEAMS`].
///
/// # Errors
/// What core refuses: nothing.
pub fn run(
    scenario: &Scenario,
    cells: &mut [u8],
    mut state: SensingState<'_>,
    workspaces: &mut [ScanWorkspace<'_>; 2],
    mut show: impl FnMut(Line),
) -> Result<(), Error> {
    let config = LocalGridMapConfig {
        width: WIDTH,
        height: HEIGHT,
        resolution: RESOLUTION,
        include_transformation: true,
        external_lidars: &["front", "rear"],
        external_odometry: "odom",
        footprint: scenario.footprint,
        radius: scenario.radius,
        name: "map",
        ..LocalGridMapConfig::default()
    };
    let mut map = LocalGridMap::new_in(cells, config)?;
    for lidar in &LIDARS {
        lidar.prepare(&mut state, BEAMS)?;
    }
    let (mut noise, mut calls) = (0x2545_f491, Hash::default());
    for tick in 0..TICKS as i32 {
        let mut ranges = [0.0; BEAMS];
        // The rear lidar is late, then says nothing now and then.
        for (lidar, is_on) in LIDARS.iter().zip([true, tick >= 3]) {
            measure(&mut noise, tick, &mut ranges);
            if is_on {
                let beams = if tick % 7 == 5 && lidar.name == "rear" {
                    0
                } else {
                    BEAMS
                };
                lidar.write(&mut state, ranges.get(..beams).unwrap_or_default())?;
            }
        }
        if tick > 0 {
            Odometry { name: "odom" }.write(&mut state, pose_at(tick), [0.0; 3])?;
        }
        let world = Pose2D::new(metres(10 * tick), metres(500), metres(50 * tick));
        let update = map.update(&state, world, workspaces)?;
        update.shift.iter().for_each(|by| calls.word(*by as u32));
        [
            update.missing_odometries,
            update.lidars,
            update.missing_lidars,
            update.empty_lidars,
            update.invalid_lidars,
            update.marks,
            update.ignored,
        ]
        .into_iter()
        .for_each(|count| calls.word(count));
        let transformation = map.transformation().unwrap_or_default();
        [transformation.x, transformation.y, transformation.theta]
            .into_iter()
            .chain(map.origin())
            .for_each(|v| calls.word(v.to_bits()));
        if tick % 8 != 7 {
            continue;
        }
        map.publish(&mut state)?;
        let mut cells = Hash::default();
        let published = map.read_gridmap(&state).map_or(&[][..], |map| map.data);
        published.iter().for_each(|cell| cells.byte(*cell));
        for (stage, hash) in [("calls", calls), ("cells", cells)] {
            show(Line {
                scenario: scenario.name,
                tick: tick as u32,
                stage,
                hash,
            });
        }
    }
    Ok(())
}
