use horus_core::prelude as core;

use super::local::{self, LocalInput};
use super::{Layers, LockstepConfig, LockstepError};
use crate::reference;

/// The std version's map.
pub(super) struct StdSide {
    map: reference::CostMap,
    model: reference::ScanModel,
    local: Option<reference::LocalGridMap>,
}

impl StdSide {
    pub fn new(config: &LockstepConfig) -> Result<Self, LockstepError> {
        let grid = reference::OccupancyGrid::try_new(
            config.width,
            config.height,
            config.resolution,
            pose(config.origin()),
        )?;
        Ok(Self {
            map: reference::CostMap::with_params(grid, params(&config.params))?,
            model: model(config.model),
            local: local::std_map(config)?,
        })
    }

    pub fn recenter(&mut self, robot: core::Pose2D) -> Result<[i32; 2], reference::ReferenceError> {
        let (dx, dy) = self.map.occupancy_grid.recenter(pose(robot))?;
        Ok([dx, dy])
    }

    pub fn integrate(
        &mut self,
        scan: &reference::LaserScan,
        sensor: core::Pose2D,
    ) -> Result<core::ScanReport, reference::ReferenceError> {
        let grid = &mut self.map.occupancy_grid;
        let report = grid.integrate_scan(scan, pose(sensor), self.model)?;
        Ok(core::ScanReport {
            changed: report.changed.map(|r| core::CellRect {
                x0: r.x0,
                y0: r.y0,
                x1: r.x1,
                y1: r.y1,
            }),
            hits: report.hits,
            misses: report.misses,
            ignored: report.ignored,
        })
    }

    /// An update of the local map, whose cells become the cost map's.
    pub fn update_local(
        &mut self,
        input: &LocalInput,
        state: &reference::SensingState,
    ) -> Result<reference::LocalUpdate, reference::ReferenceError> {
        let Some(local) = &mut self.local else {
            return Ok(reference::LocalUpdate::default());
        };
        let update = local.update(state, pose(input.robot))?;
        self.map.occupancy_grid.data = local.occupancies();
        Ok(update)
    }

    pub fn compute_costs(&mut self) {
        self.map.compute_costs();
    }

    /// Copies the map out.
    pub fn read(&self, layers: &mut Layers) {
        let grid = self.map.occupancy_grid.offset();
        layers.offset = self.local.as_ref().map_or(grid, reference::LocalGridMap::offset);
        layers.occupancy.clone_from(&self.map.occupancy_grid.data);
        layers.costs.clone_from(&self.map.costs);
    }
}

/// The same scan for the std version.
pub(super) fn scan(scan: &core::LaserScan<'_>) -> reference::LaserScan {
    reference::LaserScan {
        angle_min: scan.angle_min,
        angle_increment: scan.angle_increment,
        range_min: scan.range_min,
        range_max: scan.range_max,
        ranges: scan.ranges.to_vec(),
    }
}

/// Exact: every f32 is an f64.
fn pose(pose: core::Pose2D) -> reference::Pose2D {
    reference::Pose2D::new(pose.x.into(), pose.y.into(), pose.theta.into())
}

fn params(params: &core::CostParams) -> reference::CostParams {
    reference::CostParams {
        inflation_radius: params.inflation_radius,
        cost_scaling_factor: params.cost_scaling_factor,
        lethal_cost: params.lethal_cost,
        lethal_threshold: params.lethal_threshold,
        unknown_inflates: params.unknown_inflates,
        decay: match params.decay {
            core::Decay::Polynomial => reference::Decay::Polynomial,
            core::Decay::Exponential => reference::Decay::Exponential,
        },
        inscribed_radius: params.inscribed_radius,
        inflate_unknown: params.inflate_unknown,
    }
}

fn model(model: core::ScanModel) -> reference::ScanModel {
    match model {
        core::ScanModel::Set => reference::ScanModel::Set,
        core::ScanModel::Accumulate { hit, miss, min, max } => {
            reference::ScanModel::Accumulate { hit, miss, min, max }
        }
    }
}
