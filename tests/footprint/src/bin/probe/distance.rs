use horus_core::distance::{
    DistanceBuffers, DistanceCell, DistanceMap, DistanceMapBuffers, DistanceOptions, EnvelopeVertex,
    UnknownAs,
};
use horus_core::prelude::*;
use horus_footprint::{need, opaque};

use crate::CELLS;

/// Distances in every type.
pub fn call(grid: &StaticOccupancyGrid<CELLS>) {
    need(DistanceMapBuffers::<u16, 4, 2>::empty().split());
    of::<u16>(grid);
    of::<i16>(grid);
    of::<u32>(grid);
    of::<i32>(grid);
}

fn of<D: DistanceCell>(grid: &StaticOccupancyGrid<CELLS>) {
    let cells = &mut opaque([D::default(); 12])[..];
    let vertices = &mut opaque([EnvelopeVertex::EMPTY; 12])[..];
    compute(grid, DistanceBuffers { cells, vertices });
}

fn compute<D: DistanceCell>(grid: &StaticOccupancyGrid<CELLS>, buffers: DistanceBuffers<'_, D>) {
    let mut map = DistanceMap::new_in(opaque(buffers));
    let window = opaque(CellRect {
        x0: 1,
        y0: 2,
        x1: 3,
        y1: 4,
    });
    let options = opaque(DistanceOptions {
        max_squared: Some(5),
        unknown: UnknownAs::Obstacle,
    })
    .with_max_distance(opaque(1.0), opaque(0.05));
    need(map.compute(opaque(grid), options));
    need(map.compute_window(opaque(grid), window, options));
    need(map.begin(opaque(grid), options));
    need(map.begin_window(opaque(grid), window, options));
    need(map.advance(opaque(3)));
    let (gx, gy) = (opaque(4), opaque(5));
    need((map.window(), map.squared().len(), map.metres().last()));
    need((map.squared_at(gx, gy), map.metres_at(gx, gy)));
    need(map.nearest_obstacle(opaque(grid), gx, gy));
    need(DistanceMap::<D>::region(opaque(grid), window, options));
    if let Some(cell) = map.squared_at(gx, gy) {
        need((cell.squared(), cell.is_obstacle()));
    }
}
