//! The store of named buffers.

use horus_core::error::Buffer;
use horus_core::local::{ElementKind, GridMapView, Shape};
use horus_core::prelude::*;

#[test]
fn buffers_by_name() {
    let mut buffers = SensingBuffers::<4, 10, 12>::empty();
    let mut state = buffers.state();
    state
        .write("a", "x", Shape::line(3), &[1.0f32, 2.0, 3.0])
        .unwrap();
    state.write("", "x", Shape::line(1), &[4.0f32]).unwrap();
    state
        .write("a/b", "x", Shape::grid(2, 3), &[1u8, 2, 3, 4, 5, 6])
        .unwrap();
    assert_eq!(state.read::<f32>("a", "x").unwrap().data(), [1.0, 2.0, 3.0]);
    assert_eq!(state.read::<f32>("", "x").unwrap().data(), [4.0]);
    let grid = state.read::<u8>("a", "b/x").expect("the same name");
    assert_eq!(grid.shape(), Shape::grid(2, 3));
    assert_eq!(grid.data(), [1, 2, 3, 4, 5, 6]);
    assert!(state.read::<u8>("a", "x").is_none(), "of another type");
    assert!(state.read::<f32>("a", "y").is_none());

    state.write("a", "x", Shape::line(1), &[9.0f32]).unwrap();
    assert_eq!(state.read::<f32>("a", "x").unwrap().data(), [9.0]);
    let all: Vec<_> = state.buffers().collect();
    assert_eq!(
        all,
        [
            ("a/x", ElementKind::F32, Some(Shape::line(1))),
            ("x", ElementKind::F32, Some(Shape::line(1))),
            ("a/b/x", ElementKind::U8, Some(Shape::grid(2, 3))),
        ]
    );
    state.clear();
    assert!(state.read::<f32>("a", "x").is_none());
    assert_eq!(state.buffers().count(), 3);
}

#[test]
fn capacity() {
    let mut buffers = SensingBuffers::<3, 6, 2>::empty();
    let mut state = buffers.state();
    let small = |buffer, needed, given| {
        Err(Error::BufferTooSmall {
            buffer,
            needed,
            given,
        })
    };
    state.reserve::<f32>("a", "x", 4).unwrap();
    assert_eq!(state.reserve::<f32>("a", "x", 5), small(Buffer::Named, 5, 4));
    assert_eq!(state.reserve::<u8>("a", "x", 1), Err(Error::BufferType));
    assert_eq!(state.reserve::<f32>("a", "y", 3), small(Buffer::Floats, 3, 2));
    assert_eq!(state.reserve::<u8>("a", "y", 3), small(Buffer::Bytes, 3, 2));
    state.reserve::<u8>("a", "y", 2).unwrap();
    state.reserve::<f32>("a", "z", 0).unwrap();
    assert_eq!(state.reserve::<f32>("a", "w", 0), small(Buffer::Slots, 4, 3));
    let long = "x".repeat(33);
    assert_eq!(
        state.reserve::<f32>(&long, "x", 1),
        Err(Error::NameTooLong { given: 33 })
    );
    let field = "f".repeat(48);
    assert_eq!(
        state.reserve::<f32>("a", &field, 0),
        Err(Error::NameTooLong { given: 50 })
    );
    let written = state.write("a", "x", Shape::grid(2, 2), &[0.0f32; 3]);
    assert_eq!(written, Err(Error::LengthMismatch { needed: 4, given: 3 }));
    assert!(state.read::<f32>("a", "x").is_none(), "nothing was written");
    assert_eq!(state.buffers().count(), 3);
}

#[test]
fn sensors_take_all_their_buffers_or_none() {
    let mut buffers = SensingBuffers::<5, 9, 0>::empty();
    let mut state = buffers.state();
    let lidar = Lidar {
        name: "l",
        mount: Pose2D::default(),
        start_angle: 0.0,
        fov: 1.0,
        max_range: 1.0,
    };
    assert!(lidar.prepare(&mut state, 4).is_err(), "ten numbers");
    assert_eq!(state.buffers().count(), 0);
    lidar.prepare(&mut state, 3).unwrap();
    assert_eq!(state.buffers().count(), 5);
    assert!(lidar.write(&mut state, &[1.0; 4]).is_err());
    assert!(state.read::<f32>("l", "range").is_none());
    lidar.write(&mut state, &[1.0; 2]).unwrap();
    lidar.write(&mut state, &[1.0; 3]).unwrap();
    assert!(Odometry { name: "o" }.prepare(&mut state).is_err());
    assert_eq!(state.buffers().count(), 5);
}

#[test]
fn published_maps() {
    let config = LocalGridMapConfig {
        name: "map",
        ..LocalGridMapConfig::default()
    };
    let mut map = LocalGridMap::new_in([0; 100], config).unwrap();
    let mut small = SensingBuffers::<4, 6, 99>::empty();
    let mut state = small.state();
    assert!(map.publish(&mut state).is_err());
    assert_eq!(state.buffers().count(), 0);
    let mut buffers = SensingBuffers::<4, 6, 100>::empty();
    let mut state = buffers.state();
    assert!(map.read_gridmap(&state).is_none());
    map.update(&state, Pose2D::new(1.0, 2.0, 0.5), &mut []).unwrap();
    map.publish(&mut state).unwrap();
    let view = GridMapView::read_gridmap_with_name(&state, "map").unwrap();
    assert_eq!((view.width, view.height, view.resolution), (10, 10, 0.1));
    assert_eq!(view.data, map.data());
    assert_eq!(map.read_transformation(&state), None, "not included");
    assert!(GridMapView::read_gridmap_with_name(&state, "other").is_none());

    let config = LocalGridMapConfig {
        include_transformation: true,
        ..config
    };
    map.reset(config).unwrap();
    map.update(&state, Pose2D::new(1.0, 2.0, 0.5), &mut []).unwrap();
    map.publish(&mut state).unwrap();
    assert_eq!(
        map.read_transformation(&state),
        Some(Pose2D::default()),
        "no odometry"
    );
}
