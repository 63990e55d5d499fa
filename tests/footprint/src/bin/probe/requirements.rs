use horus_core::grid::{
    At, DenseGrid2, Frame, GridView, HorusValues, InFrame, Local, LocalMapValues, OccupancyGrid2d, Point,
    TrinaryValues, ValueTraits,
};
use horus_core::nalgebra::{Isometry2, Point2, UnitComplex, Vector2};
use horus_core::prelude::*;
use horus_core::raycast::{CellWalk, RayCaster, WalkRule};
use horus_footprint::{need, opaque};

/// What is asked of any grid, by every kind of argument.
pub fn call(grid: &StaticOccupancyGrid<{ crate::CELLS }>) {
    all(grid);
    view(grid.data(), HorusValues);
    view(grid.data(), TrinaryValues);
    view(opaque(&[0u8, 128, 255][..]), LocalMapValues);
    for rule in [WalkRule::Standard, WalkRule::Supercover, WalkRule::Navground] {
        let cell = || Vector2::new(opaque(1), opaque(2));
        let mut walk = CellWalk::new(cell(), cell(), opaque(rule));
        need((walk.size_hint(), walk.next(), walk.last()));
    }
}

fn view<V: ValueTraits>(cells: &[V::Value], values: V) {
    let pose = opaque(Pose2D::new(1.0, 2.0, 3.0));
    if let Ok(view) = GridView::new(cells, opaque(3), opaque(1), opaque(0.1), pose, values) {
        all(&view);
        if let Ok(view) = GridView::with_info(*view.info(), opaque(cells), values) {
            all(&view);
        }
    }
}

fn all<G: OccupancyGrid2d>(grid: &G) {
    at(grid, opaque((3, 4)));
    at(grid, Vector2::new(opaque(3), opaque(4)));
    at(grid, opaque(5usize));
    near(grid, opaque((1.0, 2.0)));
    near(grid, Vector2::new(opaque(1.0), opaque(2.0)));
    near(grid, Point2::new(opaque(1.0), opaque(2.0)));
    need((grid.resolution(), grid.width(), grid.height(), grid.origin()));
    need((grid.size(), grid.data().len()));
    need((
        grid.free_cells().count(),
        grid.obstacle_data().filter(|o| *o).count(),
    ));
    need(grid.unknown_mask().filter(|u| *u).count());
    need(grid.obstacle_edge_mask().filter(|e| *e).count());
    need(
        grid.coordinates_for(grid.free_cells(), opaque(Frame::Global))
            .last(),
    );
    if let Some(value) = grid.data_at(opaque(0usize)) {
        let values = grid.value_traits();
        need((
            values.is_free(value),
            values.is_occupied(value),
            values.is_unknown(value),
        ));
    }
    for rule in [WalkRule::Standard, WalkRule::Supercover, WalkRule::Navground] {
        let pose: Isometry2<f32> = opaque(Pose2D::new(1.0, 2.0, 3.0)).isometry();
        let rays = RayCaster::new(grid, pose, opaque(2.0), opaque(rule));
        let bearing = opaque(UnitComplex::identity());
        need((rays.cast(bearing), rays.trace(bearing).last()));
    }
}

fn at<G: OccupancyGrid2d, A: At<G>>(grid: &G, at: A) {
    need((grid.contains(at), grid.index_at(at), grid.free_at(at)));
    need(grid.data_at(at).is_some());
    need((at.cell(grid), At::value(at, grid).is_some()));
    need(grid.coordinates_at(at, opaque(Local)));
    need(grid.coordinates_at(at, opaque(Frame::Global)));
    need(grid.neighborhood4(at).count());
    need(opaque(Frame::Local).place(grid, Vector2::new(opaque(1.0), opaque(2.0))));
    need(DenseGrid2::value(grid, Vector2::new(opaque(1), opaque(2))).is_some());
}

fn near<G: OccupancyGrid2d>(grid: &G, point: impl Point) {
    need((point.vector(), grid.cell_near(point), grid.free_near(point)));
    need(grid.data_near(point).is_some());
    need((grid.global_from_local(point), grid.local_from_global(point)));
}
