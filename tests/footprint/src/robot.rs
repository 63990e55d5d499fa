//! A robot's mapping, as firmware has it.

use horus_core::costmap::FieldCell;
use horus_core::prelude::*;

use crate::{need, opaque};

/// What the README's firmware does: make, move, scan, update, look up.
pub fn drive<F: FieldCell>(
    (cells, buffers): (&mut [i8], CostBuffers<'_, F>),
    workspace: &mut ScanWorkspace<'_>,
    ranges: &[f32],
    side: u32,
) -> Result<(), Error> {
    let mut map = map(cells, buffers, side)?;
    loop {
        tick(&mut map, workspace, ranges)?;
    }
}

/// One turn of it: move, scan, update, look up.
#[inline(always)]
pub fn tick<F: FieldCell>(
    map: &mut CostMap<'_, F>,
    workspace: &mut ScanWorkspace<'_>,
    ranges: &[f32],
) -> Result<(), Error> {
    let pose = opaque(Pose2D::new(0.4, 0.7, 0.0));
    need(map.recenter(pose)?);
    need(map.integrate_scan(&scan(ranges), pose, ScanModel::Set, workspace)?);
    need(map.update_costs());
    need((map.cost(opaque(1.0), 2.0), map.cost_at(opaque(1), 2)));
    Ok(())
}

/// Every operation of a cost map.
pub fn use_all<F: FieldCell>(
    (cells, buffers): (&mut [i8], CostBuffers<'_, F>),
    workspace: &mut ScanWorkspace<'_>,
    ranges: &[f32],
    side: u32,
) -> Result<(), Error> {
    let mut map = map(cells, buffers, side)?;
    loop {
        let pose = opaque(Pose2D::new(0.4, 0.7, 0.0));
        need(map.recenter(pose)?);
        need(map.integrate_scan(&scan(ranges), pose, opaque(ScanModel::Set), workspace)?);
        need(map.set_occupancy(opaque(3), opaque(4), opaque(100)));
        need(map.update_costs());
        need(map.update_costs_within(opaque(100_000))?);
        need((map.min_budget(), map.calls_left()));
        map.set_params(opaque(CostParams::default()))?;
        need((map.cost(opaque(1.0), 2.0), map.cost_at(opaque(1), 2)));
        map.row(opaque(3)).for_each(need);
        need(map.footprint_cost(pose, opaque(&[(0.3, 0.2), (-0.3, 0.2), (-0.3, -0.2)]))?);
        let grid = map.occupancy_grid();
        need((
            grid.world_to_grid(opaque(1.0), 2.0),
            grid.grid_to_world(opaque(1), 2),
        ));
        need((grid.occupancy(opaque(1), 2), grid.is_free(opaque(1.0), 2.0)));
    }
}

/// A cost map of so many cells along either side.
#[inline(always)]
pub fn map<'a, F: FieldCell>(
    cells: &'a mut [i8],
    buffers: CostBuffers<'a, F>,
    side: u32,
) -> Result<CostMap<'a, F>, Error> {
    let grid = OccupancyGrid::new_in(cells, side, side, 0.05, opaque(Pose2D::new(-5.0, -5.0, 0.1)))?;
    CostMap::new_in(grid, buffers, opaque(CostParams::nav2()))
}

/// A scan of unknown geometry.
pub fn scan(ranges: &[f32]) -> LaserScan<'_> {
    LaserScan {
        angle_min: opaque(0.0),
        angle_increment: opaque(0.01745),
        range_min: opaque(0.1),
        range_max: opaque(8.0),
        ranges,
    }
}
