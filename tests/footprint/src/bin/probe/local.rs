use horus_core::costmap::{CostMapBuffers, bit_words};
use horus_core::local::{BufferSlot, GridMapView, PropertyValue, Shape};
use horus_core::prelude::*;
use horus_footprint::{in_bss, need, opaque};

use crate::CELLS;

/// Named buffers of the probe.
type State = SensingBuffers<20, 800, CELLS>;

pub fn call(cells: &mut [u8; CELLS], ranges: &[f32]) {
    let pose = opaque(Pose2D::new(1.0, 2.0, 3.0));
    let lidars = opaque([Lidar {
        name: "own",
        mount: pose,
        start_angle: 0.0,
        fov: 1.0,
        max_range: 4.0,
    }]);
    let names = opaque(["a", "b"]);
    let mut config = LocalGridMapConfig {
        width: opaque(60),
        height: opaque(61),
        external_lidars: opaque(&names[..]),
        external_odometry: opaque("odom"),
        footprint: opaque(Footprint::Circular),
        lidars: opaque(&lidars[..]),
        odometry: opaque(Some(Odometry { name: "wheels" })),
        name: opaque("map"),
        ..LocalGridMapConfig::new()
    };
    need(config.set(opaque("width"), opaque(PropertyValue::Int(50))));
    need(
        config
            .get(opaque("footprint"))
            .map(|value| value.kind().as_str().len()),
    );
    need(
        opaque("circular")
            .parse::<Footprint>()
            .map(|footprint| footprint.as_str().len()),
    );
    need((LocalGridMapConfig::properties().len(), config.validate().is_ok()));
    need(config.lidar_names().count());

    let mut state = state();
    sense(&mut state, &lidars, ranges);
    let beams = in_bss!([ScanBuffers<360, 0>; 3], [const { ScanBuffers::empty() }; 3]);
    let mut workspaces = beams.each_mut().map(ScanBuffers::workspace);
    let Ok(mut map) = LocalGridMap::new_in(opaque(&mut cells[..]), opaque(config)) else {
        return;
    };
    need(map.reset(opaque(config)));
    need(map.update(&state, pose, opaque(&mut workspaces[..])));
    need(map.recenter(pose));
    need(map.load(opaque(ranges_as_bytes())));
    map.clear();
    need(map.prepare(&mut state));
    need(map.publish(&mut state));
    need(map.read_gridmap(&state).map(|map| map.data.len()));
    need(map.read_transformation(&state));
    let name = opaque("map");
    need(GridMapView::read_gridmap_with_name(&state, name).map(|map| map.data.len()));
    need(GridMapView::read_transformation_with_name(&state, name));
    read(&map);
    follow(&map);
}

fn ranges_as_bytes() -> &'static [u8] {
    &[1, 2, 3]
}

fn state() -> SensingState<'static> {
    let buffers = in_bss!(State, State::empty());
    let (slots, floats) = (
        in_bss!([BufferSlot; 4], [BufferSlot::EMPTY; 4]),
        in_bss!([f32; 8], [0.0; 8]),
    );
    let mut own = SensingState::new_in(opaque(slots), opaque(floats), opaque(&mut []));
    own.clear();
    need(own.buffers().count());
    buffers.state()
}

fn sense(state: &mut SensingState<'_>, lidars: &[Lidar<'_>], ranges: &[f32]) {
    for lidar in lidars {
        need(lidar.validate());
        need(lidar.prepare(state, opaque(360)));
        need(lidar.write(state, opaque(ranges)));
    }
    let odometry = opaque(Odometry { name: "odom" });
    need(odometry.prepare(state));
    need(odometry.write(state, opaque(Pose2D::new(1.0, 2.0, 3.0)), opaque([0.0; 3])));
    need(Odometry::read_pose(state, opaque("odom")));
    need(state.reserve::<u8>(opaque("x"), opaque("y"), opaque(3)));
    let shape = opaque(Shape::grid(opaque(1), opaque(3)));
    need(state.write::<f32>(opaque("a"), opaque("range"), shape, opaque(&[1.0, 2.0, 3.0])));
    need(state.write::<u8>(
        opaque("x"),
        opaque("y"),
        Shape::line(opaque(3)),
        opaque(&[1, 2, 3]),
    ));
    if let Some(view) = state.read::<f32>(opaque("a"), opaque("range")) {
        let shape = view.shape();
        need((
            shape.dimensions(),
            shape.rows(),
            shape.columns(),
            shape.elements(),
        ));
        need(view.data().len());
    }
}

fn read(map: &LocalGridMap<'_, &mut [u8]>) {
    let (x, y) = (opaque(1.0), opaque(2.0));
    need((map.width(), map.height(), map.resolution(), map.offset()));
    need((map.origin(), map.data().len(), map.info().cells()));
    need((map.config().lidars.len(), map.transformation()));
    need((
        map.value(opaque(1), opaque(2)),
        map.occupancy(opaque(1), opaque(2)),
    ));
    need((map.cell_at(x, y), map.value_at(x, y)));
    need(map.occupancies().map(i32::from).sum::<i32>());
}

fn follow(map: &LocalGridMap<'_, &mut [u8]>) {
    type Buffers = CostMapBuffers<400, { bit_words(20, 20) }>;
    let (cells, buffers) = in_bss!(Buffers, Buffers::empty()).split();
    if let Ok(grid) = OccupancyGrid::new_in(cells, opaque(20), opaque(20), opaque(0.1), Pose2D::default())
        && let Ok(mut costs) = CostMap::new_in(grid, buffers, CostParams::default())
    {
        need(map.update_cost_map(&mut costs));
    }
}
