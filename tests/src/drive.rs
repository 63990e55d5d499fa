//! A scripted drive through a made-up room: scans in, rolling grid, incremental cost map.

use horus_core::costmap::{CostMapBuffers, FieldCell, bit_words};
use horus_core::prelude::*;

/// Beams of the lidar.
pub const BEAMS: usize = 180;
const RANGE_MAX: f32 = 6.0;

/// Ticks of a drive.
const TICKS: u32 = 30;
/// Nanoseconds between two ticks.
const PERIOD_NS: u64 = 100_000_000;

/// What happened in one tick.
#[derive(Clone, Copy, Debug)]
pub struct Tick<'a> {
    /// Its number, from 0.
    pub number: u32,
    /// Time of the scan in nanoseconds.
    pub stamp_ns: u64,
    /// The robot and, in its middle, the lidar; the heading lies in -pi..=pi.
    pub pose: Pose2D,
    /// The scan.
    pub scan: LaserScan<'a>,
    /// Cells that the window moved by.
    pub shift: [i32; 2],
    /// What the scan did.
    pub report: ScanReport,
    /// What the update changed.
    pub costs_changed: Option<CellRect>,
    /// What a budgeted update left.
    pub pending: Option<u32>,
}

/// How one drive differs from the others.
#[derive(Clone, Copy, Debug)]
pub struct Scenario {
    /// Its name in the report.
    pub name: &'static str,
    /// Parameters of the cost map.
    pub params: CostParams,
    /// How scans change cells.
    pub model: ScanModel,
    /// Heading of the grid's frame in radians.
    pub theta: f32,
    /// Budget of an update above the smallest, in cell visits; `None`: unlimited.
    pub budget: Option<u32>,
}

/// Drives with a one-byte field.
pub fn near_scenarios() -> [Scenario; 4] {
    let base = Scenario {
        name: "horus defaults",
        params: CostParams::default(),
        model: ScanModel::Set,
        theta: 0.0,
        budget: None,
    };
    let wide = CostParams {
        inflation_radius: 0.75,
        cost_scaling_factor: 3.0,
        ..CostParams::nav2()
    };
    [
        base,
        Scenario {
            name: "nav2 accumulating",
            params: CostParams::nav2(),
            model: ScanModel::accumulate(),
            ..base
        },
        Scenario {
            name: "horus 0.4.1 turned",
            params: CostParams::horus(),
            theta: 0.7,
            ..base
        },
        Scenario {
            name: "R = 15 budgeted",
            params: wide,
            budget: Some(2000),
            ..base
        },
    ]
}

/// Drives with a two-byte field.
pub fn far_scenarios() -> [Scenario; 1] {
    let params = CostParams {
        inflation_radius: 1.0,
        cost_scaling_factor: 2.0,
        ..CostParams::nav2()
    };
    [Scenario {
        name: "R = 20",
        params,
        model: ScanModel::Set,
        theta: 0.0,
        budget: None,
    }]
}

impl Scenario {
    /// The pose of the window's corner before it first moves: the robot starts in the middle.
    fn origin(&self, side: u32) -> Pose2D {
        let half = side as f32 * 0.025;
        Pose2D::new(-half, -half, self.theta)
    }
}

/// Cells per side of the one-byte drives.
pub const NEAR: u32 = 150;
/// Cells per side of the two-byte drives.
pub const FAR: u32 = 100;
/// Storage of a one-byte drive.
pub type NearBuffers = CostMapBuffers<{ (NEAR * NEAR) as usize }, { bit_words(NEAR, NEAR) }>;
/// Storage of a two-byte drive.
pub type FarBuffers = CostMapBuffers<{ (FAR * FAR) as usize }, { bit_words(FAR, FAR) }, u16, 2048>;
/// Beam slots, and bits for accumulating scans.
pub type LidarBuffers = ScanBuffers<BEAMS, { (NEAR * NEAR).div_ceil(32) as usize }>;

/// Runs one scenario on `side` x `side` cells and shows the map after every tick.
///
/// # Errors
/// What core refuses; nothing, unless the buffers are too small.
pub fn run<F: FieldCell>(
    scenario: &Scenario,
    side: u32,
    (cells, buffers): (&mut [i8], CostBuffers<'_, F>),
    workspace: &mut ScanWorkspace<'_>,
    mut show: impl FnMut(&CostMap<'_, F>, &Tick<'_>),
) -> Result<(), Error> {
    let grid = OccupancyGrid::new_in(cells, side, side, 0.05, scenario.origin(side))?;
    let mut map = CostMap::new_in(grid, buffers, scenario.params)?;
    let mut room = Room { noise: 0x2545_f491 };
    let mut ranges = [0.0; BEAMS];
    for number in 0..TICKS {
        let t = number as f32;
        let pose = pose_at(number);
        room.measure(pose, t, &mut ranges);
        let scan = LaserScan {
            angle_min: -core::f32::consts::PI,
            angle_increment: core::f32::consts::TAU / BEAMS as f32,
            range_min: 0.1,
            range_max: RANGE_MAX,
            ranges: &ranges,
        };
        let shift = map.recenter(pose)?;
        let report = map.integrate_scan(&scan, pose, scenario.model, workspace)?;
        let (costs_changed, pending) = match scenario.budget {
            None => (map.update_costs(), None),
            Some(extra) => {
                let update = map.update_costs_within(map.min_budget() + extra)?;
                (update.changed, Some(update.pending))
            }
        };
        let tick = Tick {
            number,
            stamp_ns: PERIOD_NS * (u64::from(number) + 1),
            pose,
            scan,
            shift,
            report,
            costs_changed,
            pending,
        };
        show(&map, &tick);
    }
    Ok(())
}

/// A drift of most of a cell per tick, and one far jump.
fn pose_at(number: u32) -> Pose2D {
    let t = number as f32;
    let jump = if number == 20 { 30.0 } else { 0.0 };
    let theta = 0.11 * t;
    let turn = if theta > core::f32::consts::PI {
        core::f32::consts::TAU
    } else {
        0.0
    };
    Pose2D::new(0.037 * t + jump, 0.021 * t - 0.3, theta - turn)
}

/// Walls around the robot, a pillar, and noise.
struct Room {
    noise: u32,
}

impl Room {
    fn measure(&mut self, pose: Pose2D, t: f32, ranges: &mut [f32]) {
        let (x, y) = (pose.x % 5.0, pose.y % 4.0);
        for (i, range) in ranges.iter_mut().enumerate() {
            let angle =
                pose.theta - core::f32::consts::PI + i as f32 * (core::f32::consts::TAU / BEAMS as f32);
            let (s, c) = (libm::sinf(angle), libm::cosf(angle));
            let to = |from: f32, dir: f32, low: f32, high: f32| {
                if dir > 0.0 {
                    (high - from) / dir
                } else {
                    (low - from) / dir
                }
            };
            let wall = to(x, c, -2.5, 7.5).min(to(y, s, -2.0, 3.0));
            // A pillar that wanders; its near side along the beam.
            let (px, py) = (1.5 - x + 0.02 * t, 1.0 - y);
            let (along, across) = (px * c + py * s, py * c - px * s);
            let pillar = if along > 0.0 && across.abs() < 0.25 {
                along - 0.2
            } else {
                f32::INFINITY
            };
            let noise = self.next();
            *range = match noise % 97 {
                0 => f32::NAN,
                1 => f32::NEG_INFINITY,
                2 => 0.01,
                _ => wall.min(pillar) + (noise % 64) as f32 * 0.001,
            };
        }
    }

    fn next(&mut self) -> u32 {
        self.noise ^= self.noise << 13;
        self.noise ^= self.noise >> 17;
        self.noise ^= self.noise << 5;
        self.noise >> 8
    }
}
