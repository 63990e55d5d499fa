use horus_core::costmap::{bit_words, scratch_words};
use horus_core::prelude::*;
use horus_core::storage::bitmap_words;
use horus_footprint::{need, opaque};

pub fn call() {
    let pose = Pose2D::new(opaque(1.0), opaque(2.0), opaque(3.0));
    need((pose.is_finite(), pose.isometry()));

    need(opaque(GridInfo::EMPTY));
    for info in [
        opaque(GridInfo::EMPTY),
        GridInfo::new(opaque(8), opaque(9), opaque(0.05), pose).unwrap_or_default(),
    ] {
        need((info.resolution(), info.width(), info.height(), info.cells()));
        need((info.offset(), info.origin(), info.first_origin(), info.isometry()));
        need(info.index(opaque(3), opaque(4)));
        need(info.world_to_grid(opaque(1.0), opaque(2.0)));
        need(info.grid_to_world(opaque(1), opaque(2)));
        need(info.world_to_cell(opaque(1.0), opaque(2.0)));
        need(info.shift_to(opaque(pose)));
    }

    let rect = opaque(CellRect {
        x0: 1,
        y0: 2,
        x1: 3,
        y1: 4,
    });
    need((rect.width(), rect.height(), rect.contains(opaque(5), opaque(6))));
    need(rect.union(&opaque(rect)));

    need(bitmap_words(opaque(7), opaque(8)));
    need(bit_words(opaque(7), opaque(8)));
    need(scratch_words(opaque(9)));
}
