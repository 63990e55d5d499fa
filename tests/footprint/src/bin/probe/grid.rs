use horus_core::prelude::*;
use horus_footprint::{need, opaque, robot};

use crate::CELLS;

pub fn call(grid: &mut StaticOccupancyGrid<CELLS>, ranges: &[f32], workspace: &mut ScanWorkspace<'_>) {
    let pose = opaque(Pose2D::new(1.0, 2.0, 3.0));
    need(opaque(&mut *grid).reset(opaque(60), opaque(61), opaque(0.05), pose));
    need(grid.load(opaque(&[1, 2, 3][..])));
    grid.clear();
    write(grid, ranges, workspace);
    read(grid);
    let (beams, seen) = (&mut opaque([BeamSlot::EMPTY; 4]), &mut opaque([0; 5]));
    let mut own = ScanWorkspace::new_in(opaque(&mut beams[..]), opaque(&mut seen[..]));
    need(own.beams());
    let cells = &mut opaque([0i8; 12]);
    if let Ok(mut grid) =
        OccupancyGrid::new_in(opaque(&mut cells[..]), opaque(3), opaque(4), opaque(0.1), pose)
    {
        write(&mut grid, ranges, &mut own);
        read(&grid);
    }
}

pub fn view(cells: &[i8]) {
    let pose = opaque(Pose2D::new(1.0, 2.0, 3.0));
    if let Ok(grid) = OccupancyGrid::view(cells, opaque(6), opaque(7), opaque(0.1), pose) {
        read(&grid);
    }
}

fn write<S: AsRef<[i8]> + AsMut<[i8]>>(
    grid: &mut OccupancyGrid<S>,
    ranges: &[f32],
    workspace: &mut ScanWorkspace<'_>,
) {
    let pose = opaque(Pose2D::new(1.0, 2.0, 3.0));
    need(grid.set_occupancy(opaque(3), opaque(4), opaque(100)));
    need(grid.recenter(pose));
    for model in [opaque(ScanModel::Set), opaque(ScanModel::accumulate())] {
        need(grid.integrate_scan(&robot::scan(opaque(ranges)), pose, model, workspace));
    }
    grid.set_frame_id(opaque("map"));
    grid.set_metadata(opaque("text"));
    opaque(grid);
}

fn read<S: AsRef<[i8]>>(grid: &OccupancyGrid<S>) {
    let (x, y) = (opaque(1.0), opaque(2.0));
    need((
        grid.info().cells(),
        grid.resolution(),
        grid.width(),
        grid.height(),
    ));
    need((grid.origin(), grid.data().len(), grid.world_to_grid(x, y)));
    need((
        grid.grid_to_world(opaque(1), opaque(2)),
        grid.occupancy(opaque(1), opaque(2)),
    ));
    need((grid.is_free(x, y), grid.is_occupied(x, y)));
    need((grid.frame_id_str(), grid.metadata_str()));
}
