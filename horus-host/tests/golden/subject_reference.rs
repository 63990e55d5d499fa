//! The subject of the tests is the std version.

use horus_host::prelude::{CostMap, OccupancyGrid, Pose2D, ReferenceError};
use horus_host::reference::{
    LidarScan, LocalFootprint, LocalGridMap, LocalGridMapConfig, SensingState, inflate,
};

use crate::local_map::{TraceMap, TraceScan};
use crate::maps::{LiveMap, MapCase};

pub use horus_host::prelude::CostParams;
pub type Error = ReferenceError;

/// Cells from a boundary within which a point counts as lying on it: all that the boundary rule's 2^-10 covers.
pub const ON_BOUNDARY: f64 = 9e-4;

/// A coordinate as the subject takes it.
pub fn seen(coordinate: f64) -> f64 {
    coordinate
}

/// How far, in metres, a cell's centre may be off on a map within `extent` metres of the world's origin.
pub fn centre_error(_extent: f64) -> f64 {
    0.0
}

/// Whether the error says that a cost map parameter is out of its range.
pub fn is_bad_parameter(error: &Error) -> bool {
    matches!(error, ReferenceError::CostParam { .. })
}

/// Costs from base costs that no occupancy has: 254 an obstacle, 255 unknown.
pub fn inflate_base_costs(base: &[u8], width: u32, resolution: f32, params: CostParams) -> Option<Vec<u8>> {
    Some(inflate(base, width as usize, resolution, &params))
}

/// Runs `check` on the cost map of a grid.
///
/// # Errors
/// A geometry or parameter that the subject refuses.
pub fn for_each_map(
    case: &MapCase,
    params: CostParams,
    check: &mut dyn FnMut(&mut dyn LiveMap),
) -> Result<(), Error> {
    let Grid(grid) = Grid::of(case)?;
    check(&mut CostMap::with_params(grid, params)?);
    Ok(())
}

impl LiveMap for CostMap {
    fn set_occupancy(&mut self, gx: u32, gy: u32, value: i8) -> bool {
        self.occupancy_grid.set_occupancy(gx, gy, value)
    }

    fn update(&mut self) {
        self.compute_costs();
    }

    fn cells(&self) -> Vec<i8> {
        self.occupancy_grid.data.clone()
    }

    fn costs(&self) -> Vec<u8> {
        self.costs.clone()
    }

    fn world_to_grid(&self, x: f64, y: f64) -> Option<(u32, u32)> {
        self.occupancy_grid.world_to_grid(x, y)
    }

    fn cost(&self, x: f64, y: f64) -> Option<u8> {
        CostMap::cost(self, x, y)
    }

    fn way(&self) -> &str {
        "std version"
    }
}

/// An occupancy grid under test.
pub struct Grid(OccupancyGrid);

impl Grid {
    pub fn new(width: u32, height: u32, resolution: f32, origin: [f64; 3]) -> Result<Self, Error> {
        let [x, y, theta] = origin;
        OccupancyGrid::try_new(width, height, resolution, Pose2D::new(x, y, theta)).map(Self)
    }

    pub fn of(case: &MapCase) -> Result<Self, Error> {
        let mut grid = Self::new(case.width, case.height, case.resolution, case.origin)?;
        grid.0.data.clone_from(&case.cells);
        Ok(grid)
    }

    pub fn cells(&self) -> &[i8] {
        &self.0.data
    }

    pub fn set_occupancy(&mut self, gx: u32, gy: u32, value: i8) -> bool {
        self.0.set_occupancy(gx, gy, value)
    }

    pub fn occupancy(&self, gx: u32, gy: u32) -> Option<i8> {
        self.0.occupancy(gx, gy)
    }

    pub fn world_to_grid(&self, x: f64, y: f64) -> Option<(u32, u32)> {
        self.0.world_to_grid(x, y)
    }

    pub fn grid_to_world(&self, gx: u32, gy: u32) -> Option<(f64, f64)> {
        self.0.grid_to_world(gx, gy)
    }

    pub fn is_free(&self, x: f64, y: f64) -> bool {
        self.0.is_free(x, y)
    }

    pub fn is_occupied(&self, x: f64, y: f64) -> bool {
        self.0.is_occupied(x, y)
    }

    pub fn recenter(&mut self, [x, y, theta]: [f64; 3]) -> Result<[i32; 2], Error> {
        let (sx, sy) = self.0.recenter(Pose2D::new(x, y, theta))?;
        Ok([sx, sy])
    }
}

/// Whether a cell of this value, also one that cannot be set, is free and occupied, and how it reads.
pub fn cell_of_value(value: i8) -> (bool, bool, Option<i8>) {
    let case = MapCase::new((1, 1), 1.0, vec![value]);
    let grid = Grid::of(&case).expect("a legal grid");
    (
        grid.is_free(0.5, 0.5),
        grid.is_occupied(0.5, 0.5),
        grid.occupancy(0, 0),
    )
}

/// A local map under test.
pub struct LocalMap(LocalGridMap);

impl LocalMap {
    pub fn new(trace: &TraceMap) -> Self {
        let config = LocalGridMapConfig {
            width: trace.width,
            height: trace.height,
            resolution: trace.resolution,
            footprint: match &*trace.footprint {
                "rectangular" => LocalFootprint::Rectangular,
                "circular" => LocalFootprint::Circular,
                _ => LocalFootprint::None,
            },
            radius: trace.radius,
            lidars: trace.lidars.clone(),
            external_odometry: if trace.has_odometry {
                "odom".into()
            } else {
                String::new()
            },
            ..LocalGridMapConfig::default()
        };
        Self(LocalGridMap::try_new(config).expect("a legal map"))
    }

    pub fn update(&mut self, world: [f32; 3], pose: [f32; 3], scans: &[TraceScan]) -> [i32; 2] {
        let [world, pose] = [world, pose].map(|pose| {
            let [x, y, theta] = pose.map(f64::from);
            Pose2D::new(x, y, theta)
        });
        let mut state = SensingState::default();
        let config = self.0.config().clone();
        let mut given = pose;
        if !config.external_odometry.is_empty() {
            state.write_pose(&config.external_odometry, pose);
            given = world;
        }
        for (scan, name) in scans.iter().zip(&config.lidars) {
            let scan = LidarScan {
                start_angle: scan.start_angle,
                fov: scan.fov,
                max_range: scan.max_range,
                ranges: scan.ranges.clone(),
                ..LidarScan::default()
            };
            state.write_scan(name, &scan);
        }
        let update = self.0.update(&state, given).expect("a legal update");
        assert_eq!(update.lidars as usize, scans.len());
        update.shift
    }

    pub fn data(&self) -> &[u8] {
        &self.0.data
    }

    pub fn load(&mut self, values: &[u8]) {
        self.0.data.copy_from_slice(values);
    }

    pub fn origin(&self) -> [f32; 2] {
        self.0.origin()
    }

    pub fn transformation(&self) -> [f32; 3] {
        let pose = self.0.transformation().expect("an update");
        [pose.x as f32, pose.y as f32, pose.theta as f32]
    }
}
