use horus_core::distance::{
    DistanceBuffers, DistanceCell, DistanceMap, DistanceMapBuffers, DistanceOptions, UnknownAs,
};
use horus_core::prelude::*;
use horus_footprint::{in_bss, need, opaque};

use crate::{CELLS, SIDE};

type Buffers<D> = DistanceMapBuffers<D, CELLS, { 2 * SIDE as usize }>;

/// Distances in every type.
pub fn call(grid: &StaticOccupancyGrid<CELLS>) {
    compute(grid, in_bss!(Buffers<u16>, Buffers::<u16>::empty()).split());
    compute(grid, in_bss!(Buffers<i16>, Buffers::<i16>::empty()).split());
    compute(grid, in_bss!(Buffers<u32>, Buffers::<u32>::empty()).split());
    compute(grid, in_bss!(Buffers<i32>, Buffers::<i32>::empty()).split());
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
