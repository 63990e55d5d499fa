use horus_core::prelude::{BeamSlot, Error, OccupancyGrid, Pose2D, ScanModel, ScanWorkspace};
use horus_host::reference;

use super::GridOp;
use crate::compare::{agreed, same_grids, same_reports};
use crate::scene::{BEAMS, Fill, Model, Move, Scan, core_scan, std_pose};

/// Cells that core has room for.
const ROOM: usize = 64 * 64;

/// A grid of core and one of the std version that have seen the same operations.
pub struct GridPair {
    core: OccupancyGrid<Vec<i8>>,
    std: reference::OccupancyGrid,
    /// The pose given at construction.
    origin: Pose2D,
    beams: Vec<BeamSlot>,
    seen: Vec<u32>,
}

impl Default for GridPair {
    fn default() -> Self {
        Self::new()
    }
}

impl GridPair {
    /// Two grids without cells.
    pub fn new() -> Self {
        let origin = Pose2D::default();
        let core = OccupancyGrid::new_in(vec![77; ROOM], 0, 0, 0.05, origin);
        Self {
            core: core.expect("a grid without cells is legal"),
            std: reference::OccupancyGrid::new(0, 0, 0.05, std_pose(origin)),
            origin,
            beams: vec![BeamSlot::EMPTY; BEAMS],
            seen: vec![u32::MAX; ROOM / 32],
        }
    }

    /// Does the same to both and compares everything.
    pub fn apply(&mut self, op: &GridOp) {
        match op {
            GridOp::Reset {
                size,
                resolution,
                origin,
            } => {
                let origin = origin.pose(resolution.0);
                self.reset(size.cells(), resolution.0, origin);
            }
            GridOp::Set { gx, gy, value } => self.set((*gx).into(), (*gy).into(), *value),
            GridOp::SetAnywhere { gx, gy } => self.set(*gx, *gy, 100),
            GridOp::Load(fill) => self.load(fill),
            GridOp::Scan {
                scan,
                model,
                few_bits,
            } => self.scan(scan, *model, *few_bits),
            GridOp::Recenter(to) => self.recenter(*to),
            GridOp::Query(x, y) => {
                let r = self.core.resolution();
                self.query(self.core.origin().x + x.of(r), self.core.origin().y + y.of(r));
            }
        }
        same_grids(&self.core, &self.std);
    }

    fn reset(&mut self, (width, height): (u32, u32), resolution: f32, origin: Pose2D) {
        let before = self.core.clone();
        let core = self.core.reset(width, height, resolution, origin);
        if core.is_err() {
            assert_eq!(self.core.info(), before.info(), "a refused reset changes nothing");
            assert_eq!(self.core.data(), before.data(), "a refused reset changes nothing");
        }
        let cells = u64::from(width) * u64::from(height);
        if cells > ROOM as u64 {
            // The std version would allocate them.
            let usual = resolution.is_finite() && resolution > 0.0 && origin.is_finite();
            let refused = if !usual {
                matches!(core, Err(Error::InvalidResolution(_) | Error::NonFinitePose))
            } else if width.max(height) > 1 << 30 || cells >= u64::from(u32::MAX) {
                core == Err(Error::SizeOverflow)
            } else {
                matches!(core, Err(Error::BufferTooSmall { .. }))
            };
            assert!(refused, "{width} x {height} cells: {core:?}");
            return;
        }
        let std = reference::OccupancyGrid::try_new(width, height, resolution, std_pose(origin));
        if let Some(((), std)) = agreed("reset", core, std) {
            self.std = std;
            self.origin = origin;
        }
    }

    fn set(&mut self, gx: u32, gy: u32, value: i8) {
        let core = self.core.set_occupancy(gx, gy, value);
        assert_eq!(core, self.std.set_occupancy(gx, gy, value), "set_occupancy");
        assert_eq!(
            self.core.occupancy(gx, gy),
            self.std.occupancy(gx, gy),
            "occupancy"
        );
    }

    fn load(&mut self, fill: &Fill) {
        let values = fill.values(self.std.data.len());
        self.core.load(&values).expect("one value per cell");
        for (cell, value) in self.std.data.iter_mut().zip(&values) {
            *cell = (*value).clamp(-1, 100);
        }
        let one_more = self.core.load(&vec![0; values.len() + 1]);
        assert!(matches!(one_more, Err(Error::LengthMismatch { .. })));
    }

    fn scan(&mut self, scan: &Scan, model: Model, few_bits: bool) {
        let origin = self.core.origin();
        let (scan, sensor) = scan.std(self.core.resolution(), (origin.x, origin.y));
        let (core_model, std_model) = model.both();
        let needed = match core_model {
            ScanModel::Set => 0,
            ScanModel::Accumulate { .. } => self.core.info().cells().div_ceil(32),
        };
        let given = if few_bits {
            needed.saturating_sub(1)
        } else {
            needed
        };
        let mut workspace = ScanWorkspace::new_in(&mut self.beams, &mut self.seen[..given]);
        let core = self
            .core
            .integrate_scan(&core_scan(&scan), sensor, core_model, &mut workspace);
        if scan.ranges.len() > BEAMS || given < needed {
            assert!(core.is_err(), "a workspace that is too small: {core:?}");
            return;
        }
        let std = self.std.integrate_scan(&scan, std_pose(sensor), std_model);
        if let Some((core, std)) = agreed("integrate_scan", core, std) {
            same_reports(core, std);
        }
    }

    fn recenter(&mut self, to: Move) {
        let info = *self.core.info();
        let pose = to.pose(info.origin(), [info.width(), info.height()], info.resolution());
        let core = self.core.recenter(pose);
        let std = self.std.recenter(std_pose(pose));
        if let Some((core, (x, y))) = agreed("recenter", core, std) {
            assert_eq!(core, [x, y], "recenter");
        }
    }

    /// Point queries agree farther than 2e-3 cell from a boundary, where f32 can resolve that.
    fn query(&self, x: f32, y: f32) {
        let core = self.core.world_to_grid(x, y);
        if let Some((gx, gy)) = core {
            assert!(
                self.core.occupancy(gx, gy).is_some(),
                "world_to_grid leaves the grid"
            );
        }
        let far = |v: f32| !v.is_finite() || v.abs() > 50.0;
        let r = self.core.resolution();
        if !(0.024..0.6).contains(&r) || far(x) || far(y) || far(self.origin.x) || far(self.origin.y) {
            return;
        }
        let (sin, cos) = f64::from(self.origin.theta).sin_cos();
        let (dx, dy) = (
            f64::from(x) - f64::from(self.origin.x),
            f64::from(y) - f64::from(self.origin.y),
        );
        let near = |local: f64| {
            let q = local / f64::from(r);
            (q - q.round()).abs() < 2.5e-3
        };
        if self.origin.theta.abs() > 100.0 || near(cos * dx + sin * dy) || near(cos * dy - sin * dx) {
            return;
        }
        let (wx, wy) = (f64::from(x), f64::from(y));
        assert_eq!(core, self.std.world_to_grid(wx, wy), "world_to_grid({x}, {y})");
        assert_eq!(
            self.core.is_free(x, y),
            self.std.is_free(wx, wy),
            "is_free({x}, {y})"
        );
        assert_eq!(
            self.core.is_occupied(x, y),
            self.std.is_occupied(wx, wy),
            "is_occupied({x}, {y})"
        );
        if let Some((gx, gy)) = core {
            let (cx, cy) = self.core.grid_to_world(gx, gy).expect("inside");
            let (sx, sy) = self.std.grid_to_world(gx, gy).expect("inside");
            let apart = (f64::from(cx) - sx).abs().max((f64::from(cy) - sy).abs());
            assert!(
                apart < 1e-4,
                "grid_to_world({gx}, {gy}): {cx}, {cy} and {sx}, {sy}"
            );
        }
    }
}
