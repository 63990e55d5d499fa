use horus_core::prelude::{BeamSlot, CostBuffers, CostMap, CostParams, OccupancyGrid, Pose2D, ScanWorkspace};
use horus_core::storage::bitmap_words;
use horus_host::reference;

use super::params::{effective_radius, is_acceptable};
use super::promises::{Promises, shifted};
use super::{CostCase, CostOp, Params, StdParams, Storage, Width};
use crate::compare::{agreed, difference, is_within, same_cells, same_grids, same_reports};
use crate::number::Number;
use crate::scene::{BEAMS, Fill, Model, Move, Place, Scan, core_scan, std_pose};

/// Cells from the map, and from its first place, within which both sides' footprints must agree:
/// far beyond, f32 no longer tells which cells an edge separates.
const FOOTPRINT_REACH: f32 = (1 << 20) as f32;

/// Calls of a long series whose rectangles are checked.
pub(super) const CHECKED_CALLS: u32 = 12;

/// A cost map of core and a grid of the std version that have seen the same operations.
pub struct CostPair<'a, F: Width> {
    pub(super) core: CostMap<'a, F>,
    pub(super) std: reference::OccupancyGrid,
    pub(super) params: (CostParams, StdParams),
    scratch: usize,
    pub(super) promises: Promises,
    /// The window has moved since the last update.
    pub(super) moved: bool,
    /// The std version's costs of the present cells, where they have been computed.
    expected: Option<Vec<u8>>,
    beams: Vec<BeamSlot>,
    seen: Vec<u32>,
}

impl<'a, F: Width> CostPair<'a, F> {
    /// A map with the case's parameters and cells; `None` if core rightly refuses the parameters.
    pub fn new(
        grid: OccupancyGrid<&'a mut [i8]>,
        buffers: CostBuffers<'a, F>,
        std: reference::OccupancyGrid,
        case: &CostCase,
    ) -> Option<Self> {
        let resolution = std.resolution;
        let scratch = buffers.scratch.len();
        let params = case.params.both::<F>(resolution);
        let core = CostMap::new_in(grid, buffers, params.0);
        let acceptable = is_acceptable::<F>(&params.1, resolution, scratch);
        assert_eq!(
            core.is_ok(),
            acceptable,
            "new_in: {:?} with {params:?}",
            core.as_ref().err()
        );
        let core = core.ok()?;
        let seen = vec![u32::MAX; bitmap_words(std.width, std.height)];
        let mut pair = Self {
            core,
            promises: Promises::new(Vec::new(), std.width),
            std,
            params,
            scratch,
            moved: false,
            expected: None,
            beams: vec![BeamSlot::EMPTY; BEAMS],
            seen,
        };
        match &case.start {
            Some(fill) => pair.load(fill),
            None => pair.recomputed(),
        }
        Some(pair)
    }

    /// Does the same to both and compares what must be equal.
    pub fn apply(&mut self, op: &CostOp) {
        match op {
            CostOp::Set { gx, gy, value } => {
                let gx = u32::from(*gx) % (self.std.width + 1);
                let gy = u32::from(*gy) % (self.std.height + 1);
                self.change(|pair| pair.set(gx, gy, *value));
            }
            CostOp::Block { from, size, value } => self.change(|pair| {
                let (x0, y0) = (u32::from(from[0]) % 48, u32::from(from[1]) % 40);
                for gy in y0..=y0 + u32::from(size[1] % 8) {
                    for gx in x0..=x0 + u32::from(size[0] % 8) {
                        pair.set(gx, gy, value.occupancy());
                    }
                }
            }),
            CostOp::Scan { scan, model } => self.change(|pair| pair.scan(scan, *model)),
            CostOp::Recenter(to) => self.recenter(*to),
            CostOp::Within { budget, calls } => {
                for _ in 0..=calls % 4 {
                    self.update_within(*budget, true);
                }
            }
            CostOp::TooLittle(part) => self.too_little(*part),
            CostOp::Drain(budget) => self.drain(*budget),
            CostOp::Update => self.update(),
            CostOp::Compute => {
                self.core.compute_costs();
                self.recomputed();
            }
            CostOp::SetParams(params) => self.set_params(params),
            CostOp::Load(fill) => self.load(fill),
            CostOp::Footprint { place, vertices } => self.footprint(place, &vertices.0),
        }
        same_grids(self.core.occupancy_grid(), &self.std);
    }

    /// Every cost as it reads now.
    pub(super) fn read(&self) -> Vec<u8> {
        let (w, h) = (self.std.width, self.std.height);
        let cells = (0..h).flat_map(|gy| (0..w).map(move |gx| (gx, gy)));
        cells
            .map(|(gx, gy)| self.core.cost_at(gx, gy).expect("inside"))
            .collect()
    }

    pub(super) fn kept(&self) -> Option<Vec<u8>> {
        self.core.costs().map(<[u8]>::to_vec)
    }

    /// The std version's costs of the present cells.
    pub(super) fn expected(&mut self) -> Vec<u8> {
        let Self { std, params, .. } = self;
        let compute = || {
            let map = reference::CostMap::with_params(std.clone(), params.1);
            map.expect("the parameters are legal").costs
        };
        self.expected.get_or_insert_with(compute).clone()
    }

    /// Nothing is pending: every cost equals the std version's and a fresh map's.
    pub(super) fn check_exact(&mut self) {
        assert_eq!(self.core.calls_left(), 0, "calls left after a finished update");
        let (width, expected, read) = (self.std.width, self.expected(), self.read());
        same_cells("cost, core against the std version", &read, &expected, width);
        let rows: Vec<u8> = (0..self.std.height).flat_map(|gy| self.core.row(gy)).collect();
        same_cells("cost by rows", &rows, &expected, width);
        if let Some(kept) = self.core.costs() {
            same_cells("kept cost", kept, &expected, width);
        }
        same_cells("cost, fresh map", &self.fresh(), &expected, width);
        if !self.promises.shifted && self.core.costs().is_none() {
            let (union, before) = self.promises.since_exact();
            let changed = difference(before, &read, width);
            assert!(
                is_within(changed, union),
                "costs changed in {changed:?}, all updates returned {union:?}"
            );
        }
        self.promises = Promises::new(read, width);
    }

    /// The costs of a new map over the same cells.
    fn fresh(&self) -> Vec<u8> {
        let (w, h) = (self.std.width, self.std.height);
        let mut storage = Storage::<F>::new((w, h), true, false, 0xa5);
        let (cells, buffers) = storage.split();
        cells.copy_from_slice(self.core.occupancy_grid().data());
        let view = OccupancyGrid::new_in(cells, w, h, self.std.resolution, Pose2D::default());
        let mut grid = view.expect("the grid was accepted before");
        grid.load(&self.std.data).expect("one value per cell");
        let map = CostMap::new_in(grid, buffers, self.params.0).expect("the parameters were accepted");
        map.costs().expect("kept").to_vec()
    }

    /// Everything was recomputed.
    fn recomputed(&mut self) {
        self.moved = false;
        let read = self.read();
        self.promises = Promises::new(read, self.std.width);
        self.check_exact();
    }

    /// Changes cells; kept costs stay as they were.
    fn change(&mut self, change: impl FnOnce(&mut Self)) {
        let (before, kept) = (self.std.data.clone(), self.kept());
        change(self);
        self.promises.changed(&before, &self.std.data);
        self.expected = None;
        assert!(kept == self.kept(), "kept costs show the last update");
    }

    fn set(&mut self, gx: u32, gy: u32, value: i8) {
        let core = self.core.set_occupancy(gx, gy, value);
        assert_eq!(core, self.std.set_occupancy(gx, gy, value), "set_occupancy");
    }

    fn scan(&mut self, scan: &Scan, model: Model) {
        let origin = self.core.info().origin();
        let (scan, sensor) = scan.std(self.std.resolution, (origin.x, origin.y));
        let (core_model, std_model) = model.both();
        let mut workspace = ScanWorkspace::new_in(&mut self.beams, &mut self.seen);
        let core = self
            .core
            .integrate_scan(&core_scan(&scan), sensor, core_model, &mut workspace);
        if scan.ranges.len() > BEAMS {
            assert!(core.is_err(), "a workspace that is too small: {core:?}");
            return;
        }
        let std = self.std.integrate_scan(&scan, std_pose(sensor), std_model);
        if let Some((core, std)) = agreed("integrate_scan", core, std) {
            same_reports(core, std);
        }
    }

    fn recenter(&mut self, to: Move) {
        let size = (self.std.width, self.std.height);
        let kept = self.kept();
        let pose = to.pose(self.core.info().origin(), size.into(), self.std.resolution);
        let core = self.core.recenter(pose);
        let std = self.std.recenter(std_pose(pose));
        self.expected = None;
        let Some((shift, (x, y))) = agreed("recenter", core, std) else {
            assert!(kept == self.kept(), "a refused recenter changes nothing");
            return;
        };
        assert_eq!(shift, [x, y], "recenter");
        self.moved |= shift != [0, 0];
        self.promises.shift(shift, size.1);
        if let Some(before) = kept {
            let moved = shifted(
                &before.iter().map(|c| Some(*c)).collect::<Vec<_>>(),
                size,
                shift,
                None,
            );
            let after = self.core.costs().expect("kept");
            let stay = moved.iter().zip(after).all(|(a, b)| a.is_none_or(|a| a == *b));
            assert!(stay, "kept costs move with their cells");
        }
    }

    fn set_params(&mut self, params: &Params) {
        let params = params.both::<F>(self.std.resolution);
        let (read, kept, left) = (self.read(), self.kept(), self.core.calls_left());
        let result = self.core.set_params(params.0);
        let acceptable = is_acceptable::<F>(&params.1, self.std.resolution, self.scratch);
        assert_eq!(
            result.is_ok(),
            acceptable,
            "set_params: {result:?} with {params:?}"
        );
        if result.is_err() {
            let same = read == self.read() && kept == self.kept() && left == self.core.calls_left();
            assert!(
                same && *self.core.params() == self.params.0,
                "refused parameters change nothing"
            );
            return;
        }
        self.params = params;
        self.expected = None;
        let radius = effective_radius::<F>(&params.1, self.std.resolution);
        assert_eq!(Some(self.core.effective_radius()), radius, "effective radius");
        self.recomputed();
    }

    fn load(&mut self, fill: &Fill) {
        let values = fill.values(self.std.data.len());
        self.core.load(&values).expect("one value per cell");
        for (cell, value) in self.std.data.iter_mut().zip(&values) {
            *cell = (*value).clamp(-1, 100);
        }
        self.expected = None;
        self.recomputed();
    }

    fn footprint(&mut self, place: &Place, vertices: &[(Number, Number)]) {
        let (resolution, info) = (self.std.resolution, self.core.info());
        let size = [info.width(), info.height()];
        let middle = Move::Few(0, 0).pose(info.origin(), size, resolution);
        let mut pose = place.pose(resolution);
        pose.x += middle.x;
        pose.y += middle.y;
        let polygon: Vec<(f32, f32)> = vertices
            .iter()
            .map(|(x, y)| (x.of(resolution), y.of(resolution)))
            .collect();
        // The std version's footprint over what core's costs read now.
        let map = reference::CostMap::with_params(reference::OccupancyGrid::default(), self.params.1);
        let mut map = map.expect("the parameters are legal");
        map.occupancy_grid = self.std.clone();
        map.costs = self.read();
        let core = self.core.footprint_cost(pose, &polygon);
        let std = map.footprint_cost(std_pose(pose), &polygon);
        let cells = polygon.iter().flat_map(|(x, y)| [x / resolution, y / resolution]);
        let robot = [pose.x - middle.x, pose.y - middle.y].map(|v| v / resolution);
        let mut cells = cells.chain(robot).chain(info.offset().map(|o| o as f32));
        let is_near = cells.all(|c| c.abs() <= FOOTPRINT_REACH);
        if let Some((core, std)) = agreed("footprint_cost", core, std)
            && is_near
        {
            assert_eq!(
                (core.cost, core.touches_unknown, core.leaves_map),
                (std.cost, std.touches_unknown, std.leaves_map),
                "footprint_cost of {polygon:?} at {pose:?}"
            );
        }
    }
}
