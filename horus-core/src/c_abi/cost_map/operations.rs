//! What both kinds of cost map can do, whatever their field.

use crate::c_abi::geometry::horus_point;
use crate::c_abi::grid::Grid;
use crate::costmap::{CostMap, CostParams, CostUpdate, FieldCell, FootprintCost};
use crate::error::Error;
use crate::geometry::{CellRect, GridInfo, Pose2D};
use crate::grid::{LaserScan, ScanModel, ScanReport, ScanWorkspace};
use crate::local::Follower;

/// [`CostMap`]'s methods, by their names.
pub(in crate::c_abi) trait Operations {
    fn grid(&self) -> &Grid;
    fn params(&self) -> &CostParams;
    fn set_params(&mut self, params: CostParams) -> Result<(), Error>;
    fn effective_radius(&self) -> u32;
    fn compute_costs(&mut self);
    fn update_costs(&mut self) -> Option<CellRect>;
    fn update_costs_within(&mut self, budget: u32) -> Result<CostUpdate, Error>;
    fn min_budget(&self) -> u32;
    fn calls_left(&self) -> u32;
    fn pending(&self) -> u32;
    fn set_occupancy(&mut self, gx: u32, gy: u32, value: i8) -> bool;
    fn integrate_scan(
        &mut self,
        scan: &LaserScan<'_>,
        sensor_pose: Pose2D,
        model: ScanModel,
        workspace: &mut ScanWorkspace<'_>,
    ) -> Result<ScanReport, Error>;
    fn recenter(&mut self, pose: Pose2D) -> Result<[i32; 2], Error>;
    fn move_to(&mut self, offset: [i32; 2]);
    fn load(&mut self, values: &[i8]) -> Result<(), Error>;
    fn set_header(&mut self, frame_id: &str, timestamp_ns: u64);
    fn cost(&self, x: f32, y: f32) -> Option<u8>;
    fn cost_at(&self, gx: u32, gy: u32) -> Option<u8>;
    fn copy_row(&self, gy: u32, costs: &mut [u8]);
    fn costs(&self) -> Option<&[u8]>;
    fn footprint_cost(&self, pose: Pose2D, polygon: &[horus_point]) -> Result<FootprintCost, Error>;
}

impl<F: FieldCell> Operations for CostMap<'static, F> {
    fn grid(&self) -> &Grid {
        self.occupancy_grid()
    }

    fn params(&self) -> &CostParams {
        CostMap::params(self)
    }

    fn set_params(&mut self, params: CostParams) -> Result<(), Error> {
        CostMap::set_params(self, params)
    }

    fn effective_radius(&self) -> u32 {
        CostMap::effective_radius(self)
    }

    fn compute_costs(&mut self) {
        CostMap::compute_costs(self);
    }

    fn update_costs(&mut self) -> Option<CellRect> {
        CostMap::update_costs(self)
    }

    fn update_costs_within(&mut self, budget: u32) -> Result<CostUpdate, Error> {
        CostMap::update_costs_within(self, budget)
    }

    fn min_budget(&self) -> u32 {
        CostMap::min_budget(self)
    }

    fn calls_left(&self) -> u32 {
        CostMap::calls_left(self)
    }

    fn pending(&self) -> u32 {
        CostMap::pending(self)
    }

    fn set_occupancy(&mut self, gx: u32, gy: u32, value: i8) -> bool {
        CostMap::set_occupancy(self, gx, gy, value)
    }

    fn integrate_scan(
        &mut self,
        scan: &LaserScan<'_>,
        sensor_pose: Pose2D,
        model: ScanModel,
        workspace: &mut ScanWorkspace<'_>,
    ) -> Result<ScanReport, Error> {
        CostMap::integrate_scan(self, scan, sensor_pose, model, workspace)
    }

    fn recenter(&mut self, pose: Pose2D) -> Result<[i32; 2], Error> {
        CostMap::recenter(self, pose)
    }

    fn move_to(&mut self, offset: [i32; 2]) {
        CostMap::move_to(self, offset);
    }

    fn load(&mut self, values: &[i8]) -> Result<(), Error> {
        CostMap::load(self, values)
    }

    fn set_header(&mut self, frame_id: &str, timestamp_ns: u64) {
        CostMap::set_header(self, frame_id, timestamp_ns);
    }

    fn cost(&self, x: f32, y: f32) -> Option<u8> {
        CostMap::cost(self, x, y)
    }

    fn cost_at(&self, gx: u32, gy: u32) -> Option<u8> {
        CostMap::cost_at(self, gx, gy)
    }

    fn copy_row(&self, gy: u32, costs: &mut [u8]) {
        costs
            .iter_mut()
            .zip(self.row(gy))
            .for_each(|(to, cost)| *to = cost);
    }

    fn costs(&self) -> Option<&[u8]> {
        CostMap::costs(self)
    }

    fn footprint_cost(&self, pose: Pose2D, polygon: &[horus_point]) -> Result<FootprintCost, Error> {
        CostMap::footprint_cost(self, pose, polygon)
    }
}

/// What a local map sets is set here, through the map's own functions.
impl Follower for dyn Operations + 'static {
    fn info(&self) -> &GridInfo {
        self.grid().info()
    }

    fn cells(&self) -> &[i8] {
        self.grid().data()
    }

    fn move_to(&mut self, offset: [i32; 2]) {
        Operations::move_to(self, offset);
    }

    fn set_occupancy(&mut self, gx: u32, gy: u32, value: i8) {
        Operations::set_occupancy(self, gx, gy, value);
    }
}
