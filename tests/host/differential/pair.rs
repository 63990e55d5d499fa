//! A core cost map and the std version of it, side by side.

use horus_core::costmap::{CostTables, FieldCell, bit_words, scratch_words};
use horus_core::prelude::*;
use horus_host::reference as std_side;

use crate::op::Scan;

/// Buffers of a core map.
pub struct Buffers<F: FieldCell> {
    cells: Vec<i8>,
    bits: Vec<u32>,
    field: Vec<F>,
    scratch: Vec<u32>,
    costs: Option<Vec<u8>>,
    tables: CostTables<F>,
    beams: Vec<BeamSlot>,
    seen: Vec<u32>,
}

impl<F: FieldCell> Buffers<F> {
    pub fn new(w: u32, h: u32, kept: bool) -> Self {
        let n = (w * h) as usize;
        Self {
            // Garbage, on purpose: contents must not matter.
            cells: vec![77; n],
            bits: vec![0xdead_beef; bit_words(w, h)],
            field: vec![F::STALE; n],
            scratch: vec![0xdead_beef; scratch_words(F::MAX_RADIUS.min(31))],
            costs: kept.then(|| vec![13; n]),
            tables: CostTables::EMPTY,
            beams: vec![BeamSlot::EMPTY; 100],
            seen: vec![0xdead_beef; n.div_ceil(32)],
        }
    }
}

/// What a pair is made of.
#[derive(Clone, Copy, Debug)]
pub struct Setup {
    pub width: u32,
    pub height: u32,
    pub resolution: f32,
    pub origin: Pose2D,
    pub params: CostParams,
}

/// Core and the std version after the same operations.
pub struct Pair<'a, F: FieldCell> {
    pub core: CostMap<'a, F>,
    pub oracle: std_side::CostMap,
    pub workspace: ScanWorkspace<'a>,
    /// Where the robot is, metres.
    pub robot: (f32, f32),
    resolution: f32,
}

/// The std version's parameters.
pub fn std_params(p: &CostParams) -> std_side::CostParams {
    std_side::CostParams {
        inflation_radius: p.inflation_radius,
        cost_scaling_factor: p.cost_scaling_factor,
        lethal_cost: p.lethal_cost,
        lethal_threshold: p.lethal_threshold,
        unknown_inflates: p.unknown_inflates,
        decay: match p.decay {
            Decay::Polynomial => std_side::Decay::Polynomial,
            Decay::Exponential => std_side::Decay::Exponential,
        },
        inscribed_radius: p.inscribed_radius,
        inflate_unknown: p.inflate_unknown,
    }
}

pub fn std_pose(p: Pose2D) -> std_side::Pose2D {
    std_side::Pose2D::new(p.x.into(), p.y.into(), p.theta.into())
}

fn std_model(m: ScanModel) -> std_side::ScanModel {
    match m {
        ScanModel::Set => std_side::ScanModel::Set,
        ScanModel::Accumulate { hit, miss, min, max } => {
            std_side::ScanModel::Accumulate { hit, miss, min, max }
        }
    }
}

impl<'a, F: FieldCell> Pair<'a, F> {
    /// `None` if the costs reach farther than the field holds.
    pub fn new(buffers: &'a mut Buffers<F>, setup: &Setup) -> Option<Self> {
        let Setup {
            width,
            height,
            resolution,
            origin,
            params,
        } = *setup;
        let grid = OccupancyGrid::new_in(&mut buffers.cells[..], width, height, resolution, origin).unwrap();
        let cost_buffers = CostBuffers {
            bits: &mut buffers.bits,
            field: &mut buffers.field,
            scratch: &mut buffers.scratch,
            costs: buffers.costs.as_deref_mut(),
            tables: &mut buffers.tables,
        };
        let core = match CostMap::new_in(grid, cost_buffers, params) {
            Ok(core) => core,
            Err(Error::RadiusTooLarge { .. }) => return None,
            Err(error) => panic!("{error}"),
        };
        let grid = std_side::OccupancyGrid::new(width, height, resolution, std_pose(origin));
        let oracle = std_side::CostMap::with_params(grid, std_params(&params)).unwrap();
        let workspace = ScanWorkspace::new_in(&mut buffers.beams, &mut buffers.seen);
        Some(Self {
            core,
            oracle,
            workspace,
            robot: (0.0, 0.0),
            resolution,
        })
    }

    pub fn set(&mut self, gx: u32, gy: u32, value: i8) {
        let done = self.core.set_occupancy(gx, gy, value);
        assert_eq!(done, self.oracle.occupancy_grid.set_occupancy(gx, gy, value));
    }

    pub fn scan(&mut self, scan: &Scan) {
        let core_scan = LaserScan {
            angle_min: scan.angle_min,
            angle_increment: scan.angle_increment,
            range_min: 0.05,
            range_max: 3.0,
            ranges: &scan.ranges,
        };
        let std_scan = std_side::LaserScan {
            angle_min: scan.angle_min,
            angle_increment: scan.angle_increment,
            range_min: 0.05,
            range_max: 3.0,
            ranges: scan.ranges.clone(),
        };
        let pose = Pose2D::new(scan.x + self.robot.0, scan.y + self.robot.1, scan.theta);
        let got = self
            .core
            .integrate_scan(&core_scan, pose, scan.model, &mut self.workspace)
            .unwrap();
        let expected = self
            .oracle
            .occupancy_grid
            .integrate_scan(&std_scan, std_pose(pose), std_model(scan.model))
            .unwrap();
        let rect = |r: std_side::Rect| CellRect {
            x0: r.x0,
            y0: r.y0,
            x1: r.x1,
            y1: r.y1,
        };
        assert_eq!(got.changed, expected.changed.map(rect));
        assert_eq!(
            (got.hits, got.misses, got.ignored),
            (expected.hits, expected.misses, expected.ignored)
        );
    }

    pub fn recenter(&mut self, x: f32, y: f32) -> bool {
        self.robot = (x, y);
        let pose = Pose2D::new(x, y, 0.3);
        let shift = self.core.recenter(pose).unwrap();
        let expected = self.oracle.occupancy_grid.recenter(std_pose(pose)).unwrap();
        assert_eq!(shift, [expected.0, expected.1]);
        assert_eq!(self.core.info().offset(), self.oracle.occupancy_grid.offset());
        shift != [0, 0]
    }

    pub fn move_by(&mut self, dx_cells: f32, dy_cells: f32) -> bool {
        let (x, y) = self.robot;
        self.recenter(x + dx_cells * self.resolution, y + dy_cells * self.resolution)
    }

    /// Every occupancy value equal.
    pub fn check_cells(&self) {
        let (got, expected) = (
            self.core.occupancy_grid().data(),
            &self.oracle.occupancy_grid.data,
        );
        if got != &expected[..] {
            panic!("cells differ\n{}", self.picture(|i| got[i] != expected[i]));
        }
    }

    /// Every cost equal, however it is read; call it after a finished update.
    pub fn check_costs(&mut self) {
        self.oracle.compute_costs();
        let (width, height) = (self.core.info().width(), self.core.info().height());
        let got: Vec<u8> = (0..height)
            .flat_map(|gy| self.core.row(gy).collect::<Vec<_>>())
            .collect();
        let expected = &self.oracle.costs;
        if &got != expected {
            let first = (0..got.len()).find(|&i| got[i] != expected[i]).unwrap();
            panic!(
                "cost of cell ({}, {}) is {} instead of {}\n{}",
                first as u32 % width,
                first as u32 / width,
                got[first],
                expected[first],
                self.picture(|i| got[i] != expected[i])
            );
        }
        if let Some(kept) = self.core.costs() {
            assert_eq!(kept, &expected[..], "kept bytes");
        }
    }

    /// Present costs, row-major.
    pub fn costs(&self) -> Vec<u8> {
        (0..self.core.info().height())
            .flat_map(|gy| self.core.row(gy).collect::<Vec<_>>())
            .collect()
    }

    /// The grid as text, top row first: `#` lethal, `.` known, `?` unknown, `X` marked.
    fn picture(&self, marked: impl Fn(usize) -> bool) -> String {
        let width = self.core.info().width() as usize;
        let threshold = self.core.params().lethal_threshold;
        let rows = self.core.occupancy_grid().data().chunks(width).enumerate().rev();
        let mut picture = String::new();
        for (gy, row) in rows {
            for (gx, value) in row.iter().enumerate() {
                picture.push(match *value {
                    _ if marked(gy * width + gx) => 'X',
                    v if v < 0 => '?',
                    v if v >= threshold => '#',
                    _ => '.',
                });
            }
            picture.push('\n');
        }
        picture
    }
}
