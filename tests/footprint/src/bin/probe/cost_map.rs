use horus_core::costmap::{CostTables, FieldCell};
use horus_core::prelude::*;
use horus_footprint::{need, opaque, robot};

use crate::frames;

pub fn call<F: FieldCell>(
    (cells, buffers): (&mut [i8], CostBuffers<'_, F>),
    ranges: &[f32],
    workspace: &mut ScanWorkspace<'_>,
    frame: &mut [u8],
) {
    let pose = opaque(Pose2D::new(1.0, 2.0, 3.0));
    let Ok(grid) = OccupancyGrid::new_in(cells, opaque(60), opaque(61), opaque(0.05), pose) else {
        return;
    };
    let params = opaque(CostParams::horus().with_radius(opaque(0.4)));
    let Ok(mut map) = CostMap::new_in(grid, buffers, opaque(params)) else {
        return;
    };
    change(&mut map, ranges, workspace);
    need(map.set_params(opaque(CostParams::nav2())));
    read(&map);
    frames::write(&map, frame, ranges);
}

fn change<F: FieldCell>(map: &mut CostMap<'_, F>, ranges: &[f32], workspace: &mut ScanWorkspace<'_>) {
    let pose = opaque(Pose2D::new(1.0, 2.0, 3.0));
    map.set_header(opaque("map"), opaque(4));
    need(map.set_occupancy(opaque(3), opaque(4), opaque(100)));
    for model in [opaque(ScanModel::Set), opaque(ScanModel::accumulate())] {
        need(map.integrate_scan(&robot::scan(opaque(ranges)), pose, model, workspace));
    }
    need(map.recenter(pose));
    need(map.load(opaque(&[1, 2, 3][..])));
    map.compute_costs();
    need(map.update_costs());
    need(map.update_costs_within(opaque(5000)));
}

fn read<F: FieldCell>(map: &CostMap<'_, F>) {
    need((
        map.occupancy_grid().data().len(),
        map.info().cells(),
        map.params().validate(),
    ));
    need((map.effective_radius(), map.min_budget()));
    need((map.calls_left(), map.pending()));
    need((
        map.cost(opaque(1.0), opaque(2.0)),
        map.cost_at(opaque(1), opaque(2)),
    ));
    need(map.costs());
    map.row(opaque(3)).for_each(need);
    need(map.row(opaque(3)).len());
    need(map.footprint_cost(opaque(Pose2D::default()), opaque(&[(0.1, 0.2)][..])));
}

pub fn tables() {
    need((CostTables::<u8>::EMPTY, CostTables::<u16>::EMPTY));
    need(CostParams::default());
}
