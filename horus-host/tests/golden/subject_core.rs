//! The subject of the tests is `horus-core`, over buffers on the heap.

use std::fmt::Debug;

use horus_core::costmap::{CostTables, FieldCell, bit_words, scratch_words};
use horus_core::local::{BufferSlot, SensingState};
use horus_core::prelude::{
    BeamSlot, CellRect, CostBuffers, CostMap, Lidar, LocalGridMap, LocalGridMapConfig, OccupancyGrid,
    Odometry, Pose2D, ScanWorkspace,
};

use crate::local_map::{TraceMap, TraceScan};
use crate::maps::{LiveMap, MapCase};

pub use horus_core::prelude::{CostParams, Error};

/// Cells from a boundary within which a point counts as lying on it: what rounding decimals leaves.
pub const ON_BOUNDARY: f64 = 1e-6;

/// A coordinate as the subject takes it.
pub fn seen(coordinate: f64) -> f64 {
    f64::from(coordinate as f32)
}

/// How far, in metres, a cell's centre may be off on a map within `extent` metres of the world's origin.
pub fn centre_error(extent: f64) -> f64 {
    2.0 * extent * f64::from(f32::EPSILON)
}

/// Whether the error says that a cost map parameter is out of its range.
pub fn is_bad_parameter(error: &Error) -> bool {
    matches!(error, Error::InvalidParameter(_))
}

/// Base costs do not enter the core's public interface; a unit test inside it runs these vectors.
pub fn inflate_base_costs(_: &[u8], _: u32, _: f32, _: CostParams) -> Option<Vec<u8>> {
    None
}

fn pose([x, y, theta]: [f64; 3]) -> Pose2D {
    Pose2D::new(x as f32, y as f32, theta as f32)
}

/// How a map's costs come to be.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Path {
    /// `compute_costs`.
    Full,
    /// `update_costs`.
    Incremental,
    /// `update_costs_within` the smallest budget.
    Budgeted,
}

/// Runs `check` on the cost map of a grid, once for every way to keep it.
///
/// # Errors
/// A geometry or parameter that the subject refuses. A radius too large for one byte is none.
pub fn for_each_map(
    case: &MapCase,
    params: CostParams,
    check: &mut dyn FnMut(&mut dyn LiveMap),
) -> Result<(), Error> {
    for path in [Path::Full, Path::Incremental, Path::Budgeted] {
        for kept in [false, true] {
            let radius = with_map::<u16>(case, params, path, kept, check)?;
            match with_map::<u8>(case, params, path, kept, check) {
                Err(Error::RadiusTooLarge { max_cells: 15 }) if radius > 15 => {}
                one_byte => assert_eq!(one_byte, Ok(radius)),
            }
        }
    }
    Ok(())
}

/// Runs `check` on one map and returns its effective radius.
fn with_map<F: FieldCell + Debug>(
    case: &MapCase,
    params: CostParams,
    path: Path,
    kept: bool,
    check: &mut dyn FnMut(&mut dyn LiveMap),
) -> Result<u32, Error> {
    let &MapCase { width, height, .. } = case;
    let mut cells = vec![0; case.cells.len()];
    let mut field = vec![F::ZERO; case.cells.len()];
    let mut bits = vec![0; bit_words(width, height)];
    let mut scratch = vec![0; (0..=F::MAX_RADIUS).map(scratch_words).max().unwrap_or(0)];
    let mut costs = kept.then(|| vec![0; case.cells.len()]);
    let mut tables = Box::new(CostTables::<F>::EMPTY);
    let buffers = CostBuffers {
        bits: &mut bits,
        field: &mut field,
        scratch: &mut scratch,
        costs: costs.as_deref_mut(),
        tables: &mut tables,
    };
    let grid = OccupancyGrid::new_in(&mut cells[..], width, height, case.resolution, pose(case.origin))?;
    let mut map = CoreMap {
        map: CostMap::new_in(grid, buffers, params)?,
        path,
        way: format!(
            "core, {} bytes per field cell, kept costs: {kept}, {path:?}",
            size_of::<F>()
        ),
        last: Vec::new(),
    };
    map.load(&case.cells)?;
    check(&mut map);
    Ok(map.map.effective_radius())
}

/// A core cost map under test.
struct CoreMap<'a, F: FieldCell> {
    map: CostMap<'a, F>,
    path: Path,
    way: String,
    /// The costs after the last update.
    last: Vec<u8>,
}

impl<F: FieldCell> CoreMap<'_, F> {
    /// Fills the map: at once, or by turning another map into this one, with an update after every row.
    fn load(&mut self, cells: &[i8]) -> Result<(), Error> {
        if self.path == Path::Full || cells.is_empty() {
            return self.map.load(cells);
        }
        let (width, height) = (self.map.info().width(), self.map.info().height());
        let mut other = cells.to_vec();
        other.rotate_left(3 % cells.len());
        self.map.load(&other)?;
        self.last = self.costs();
        for gy in 0..height {
            for gx in 0..width {
                assert!(self.map.set_occupancy(gx, gy, cells[(gy * width + gx) as usize]));
            }
            self.update();
        }
        Ok(())
    }

    /// The rectangle of costs that changed, as the core tells it.
    fn updated(&mut self) -> Option<CellRect> {
        match self.path {
            Path::Full => unreachable!("a full computation returns no rectangle"),
            Path::Incremental => self.map.update_costs(),
            Path::Budgeted => {
                let (budget, promised) = (self.map.min_budget(), self.map.calls_left());
                let mut changed: Option<CellRect> = None;
                for call in 1.. {
                    assert!(call <= promised.max(1), "{call} calls, {promised} promised");
                    let update = self.map.update_costs_within(budget).expect("a legal budget");
                    changed = match (changed, update.changed) {
                        (Some(a), Some(b)) => Some(a.union(&b)),
                        (a, b) => a.or(b),
                    };
                    if update.pending == 0 {
                        break;
                    }
                }
                changed
            }
        }
    }
}

impl<F: FieldCell> LiveMap for CoreMap<'_, F> {
    fn set_occupancy(&mut self, gx: u32, gy: u32, value: i8) -> bool {
        self.map.set_occupancy(gx, gy, value)
    }

    fn update(&mut self) {
        if self.path == Path::Full {
            self.map.compute_costs();
            return;
        }
        let changed = self.updated();
        let costs = self.costs();
        let smallest = difference(&self.last, &costs, self.map.info().width());
        if self.map.costs().is_some() {
            assert_eq!(changed, smallest, "{}", self.way);
        } else if let Some(smallest) = smallest {
            let changed = changed.expect("a rectangle: costs changed");
            assert_eq!(changed.union(&smallest), changed, "{}", self.way);
        }
        self.last = costs;
    }

    fn cells(&self) -> Vec<i8> {
        self.map.occupancy_grid().data().to_vec()
    }

    fn costs(&self) -> Vec<u8> {
        let rows = 0..self.map.info().height();
        let costs: Vec<u8> = rows.flat_map(|gy| self.map.row(gy).collect::<Vec<_>>()).collect();
        if let Some(kept) = self.map.costs() {
            assert_eq!(kept, costs, "kept costs, {}", self.way);
        }
        costs
    }

    fn world_to_grid(&self, x: f64, y: f64) -> Option<(u32, u32)> {
        self.map.info().world_to_grid(x as f32, y as f32)
    }

    fn cost(&self, x: f64, y: f64) -> Option<u8> {
        self.map.cost(x as f32, y as f32)
    }

    fn way(&self) -> &str {
        &self.way
    }
}

/// The smallest rectangle that holds every cell in which two maps differ.
fn difference(a: &[u8], b: &[u8], width: u32) -> Option<CellRect> {
    let cells = (0..).zip(a.iter().zip(b)).filter(|(_, (a, b))| a != b);
    cells
        .map(|(i, _): (u32, _)| (i % width, i / width))
        .map(|(x, y)| CellRect {
            x0: x,
            y0: y,
            x1: x + 1,
            y1: y + 1,
        })
        .reduce(|a, b| a.union(&b))
}

/// An occupancy grid under test.
pub struct Grid(OccupancyGrid<Vec<i8>>);

impl Grid {
    pub fn new(width: u32, height: u32, resolution: f32, origin: [f64; 3]) -> Result<Self, Error> {
        let cells = vec![0; width as usize * height as usize];
        OccupancyGrid::new_in(cells, width, height, resolution, pose(origin)).map(Self)
    }

    pub fn of(case: &MapCase) -> Result<Self, Error> {
        let mut grid = Self::new(case.width, case.height, case.resolution, case.origin)?;
        grid.0.load(&case.cells)?;
        Ok(grid)
    }

    pub fn cells(&self) -> &[i8] {
        self.0.data()
    }

    pub fn set_occupancy(&mut self, gx: u32, gy: u32, value: i8) -> bool {
        self.0.set_occupancy(gx, gy, value)
    }

    pub fn occupancy(&self, gx: u32, gy: u32) -> Option<i8> {
        self.0.occupancy(gx, gy)
    }

    pub fn world_to_grid(&self, x: f64, y: f64) -> Option<(u32, u32)> {
        self.0.world_to_grid(x as f32, y as f32)
    }

    pub fn grid_to_world(&self, gx: u32, gy: u32) -> Option<(f64, f64)> {
        let (x, y) = self.0.grid_to_world(gx, gy)?;
        Some((x.into(), y.into()))
    }

    pub fn is_free(&self, x: f64, y: f64) -> bool {
        self.0.is_free(x as f32, y as f32)
    }

    pub fn is_occupied(&self, x: f64, y: f64) -> bool {
        self.0.is_occupied(x as f32, y as f32)
    }

    pub fn recenter(&mut self, to: [f64; 3]) -> Result<[i32; 2], Error> {
        self.0.recenter(pose(to))
    }
}

/// Whether a cell of this value, also one that cannot be set, is free and occupied, and how it reads.
pub fn cell_of_value(value: i8) -> (bool, bool, Option<i8>) {
    let cells = [value];
    let grid = OccupancyGrid::view(&cells, 1, 1, 1.0, Pose2D::default()).expect("a legal grid");
    (
        grid.is_free(0.5, 0.5),
        grid.is_occupied(0.5, 0.5),
        grid.occupancy(0, 0),
    )
}

/// A local map under test.
pub struct LocalMap {
    map: LocalGridMap<'static, Vec<u8>>,
    beams: Vec<Vec<BeamSlot>>,
}

impl LocalMap {
    pub fn new(trace: &TraceMap) -> Self {
        // The configuration borrows; a test may leak its names.
        let names: Vec<&str> = trace.lidars.iter().map(|name| &*name.clone().leak()).collect();
        let config = LocalGridMapConfig {
            width: trace.width,
            height: trace.height,
            resolution: trace.resolution,
            footprint: trace.footprint.parse().expect("a footprint"),
            radius: trace.radius,
            external_odometry: if trace.has_odometry { "odom" } else { "" },
            external_lidars: names.leak(),
            ..LocalGridMapConfig::default()
        };
        let cells = vec![7; trace.width as usize * trace.height as usize];
        Self {
            map: LocalGridMap::new_in(cells, config).expect("a legal map"),
            beams: vec![vec![BeamSlot::EMPTY; 2000]; trace.lidars.len()],
        }
    }

    pub fn update(&mut self, world: [f32; 3], pose: [f32; 3], scans: &[TraceScan]) -> [i32; 2] {
        let [world, pose] = [world, pose].map(|[x, y, theta]| Pose2D::new(x, y, theta));
        let mut slots = [BufferSlot::EMPTY; 32];
        let mut floats = vec![0.0; 10_000];
        let mut state = SensingState::new_in(&mut slots, &mut floats, &mut []);
        let config = *self.map.config();
        let mut given = pose;
        if !config.external_odometry.is_empty() {
            let odometry = Odometry {
                name: config.external_odometry,
            };
            odometry.write(&mut state, pose, [0.0; 3]).expect("room");
            given = world;
        }
        for (scan, &name) in scans.iter().zip(config.external_lidars) {
            let lidar = Lidar {
                name,
                mount: Pose2D::default(),
                start_angle: scan.start_angle,
                fov: scan.fov,
                max_range: scan.max_range,
            };
            lidar.write(&mut state, &scan.ranges).expect("room");
        }
        let workspaces = self.beams.iter_mut();
        let mut workspaces: Vec<_> = workspaces
            .map(|slots| ScanWorkspace::new_in(slots, &mut []))
            .collect();
        let update = self
            .map
            .update(&state, given, &mut workspaces)
            .expect("a legal update");
        assert_eq!(update.lidars as usize, scans.len());
        update.shift
    }

    pub fn data(&self) -> &[u8] {
        self.map.data()
    }

    pub fn load(&mut self, values: &[u8]) {
        self.map.load(values).expect("one value per cell");
    }

    pub fn origin(&self) -> [f32; 2] {
        self.map.origin()
    }

    pub fn transformation(&self) -> [f32; 3] {
        let pose = self.map.transformation().expect("an update");
        [pose.x, pose.y, pose.theta]
    }
}
