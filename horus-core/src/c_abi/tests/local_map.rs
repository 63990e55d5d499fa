use core::ptr;
use std::vec::Vec;

use super::*;
use crate::local::{FREE, OCCUPIED, UNKNOWN};

fn config() -> horus_local_map_config {
    let mut lidar_names = [[0; 32]; 4];
    (lidar_names[0][0], lidar_names[1][0]) = (b'a', b'b');
    let mut odometry = [0; 32];
    odometry[0] = b'o';
    horus_local_map_config {
        lidar_names,
        odometry,
        width: 12,
        height: 9,
        resolution: 0.1,
        lidars: 2,
        beams: 5,
        has_odometry: 1,
        publishes: 1,
        include_transformation: 1,
        ..horus_local_map_config_default()
    }
}

fn map(config: &horus_local_map_config) -> (Memory, *mut horus_local_map) {
    let (mut bytes, mut map) = (0, ptr::null_mut());
    // SAFETY: the pointers are good.
    assert_eq!(unsafe { horus_local_map_bytes(config, &mut bytes) }, Status::Ok);
    let memory = Memory::new(bytes);
    // SAFETY: the pointers are good.
    let status = unsafe { horus_local_map_init(memory.pointer(), bytes, config, &mut map) };
    assert_eq!(status, Status::Ok);
    (memory, map)
}

fn scan_of(ranges: &[f32]) -> horus_lidar_scan {
    horus_lidar_scan {
        ranges: ranges.as_ptr(),
        count: ranges.len(),
        mount: HOME,
        start_angle: -0.4,
        fov: 0.8,
        max_range: 3.0,
    }
}

/// The map's values, copied.
fn values(map: *const horus_local_map) -> Vec<u8> {
    let (mut data, mut count) = (ptr::null(), 0);
    // SAFETY: the handle is live, the pointers are good; nothing writes to the map before the copy.
    unsafe {
        assert_eq!(horus_local_map_data(map, &mut data, &mut count), Status::Ok);
        core::slice::from_raw_parts(data, count).to_vec()
    }
}

#[test]
fn local_maps_live_in_the_callers_memory() {
    let (_memory, map) = map(&config());
    let mut update = core::mem::MaybeUninit::<horus_local_update>::uninit();
    let moved = Pose2D::new(0.1, 0.0, 0.0);
    // SAFETY: the handle is live, the pointers are good; `update` is written by the call that is `Ok`.
    unsafe {
        let scan = scan_of(&[0.35; 5]);
        assert_eq!(horus_local_map_write_scan(map, 0, &scan), Status::Ok);
        assert_eq!(horus_local_map_write_odometry(map, moved, HOME), Status::Ok);
        assert_eq!(horus_local_map_update(map, HOME, update.as_mut_ptr()), Status::Ok);
        let update = update.assume_init();
        assert_eq!((update.lidars, update.missing_lidars, update.marks), (1, 1, 5));
        assert_eq!((update.missing_odometries, update.ignored), (0, 0));
        let mut cell = horus_cell::default();
        assert_eq!(horus_local_map_cell_at(map, 0.45, 0.0, &mut cell), Status::Ok);
        let mut value = 7;
        assert_eq!(
            horus_local_map_value(map, cell.gx, cell.gy, &mut value),
            Status::Ok
        );
        assert_eq!(value, OCCUPIED);
        assert_eq!(horus_local_map_value(map, 12, 0, &mut value), Status::Outside);
        let mut transformation = HOME;
        assert_eq!(
            horus_local_map_transformation(map, &mut transformation),
            Status::Ok
        );
        assert_eq!(transformation.x, -0.1);
    }
    let seen = values(map);
    assert!([FREE, OCCUPIED, UNKNOWN].iter().all(|kind| seen.contains(kind)));

    let mut view = core::mem::MaybeUninit::<horus_grid_map_view>::uninit();
    // SAFETY: as above; the view's data are read before the map changes.
    unsafe {
        assert_eq!(horus_local_map_publish(map), Status::Ok);
        assert_eq!(horus_local_map_read_gridmap(map, view.as_mut_ptr()), Status::Ok);
        let view = view.assume_init();
        assert_eq!((view.width, view.height), (12, 9));
        assert_eq!(core::slice::from_raw_parts(view.data, seen.len()), seen);
        let mut transformation = HOME;
        assert_eq!(
            horus_local_map_read_transformation(map, &mut transformation),
            Status::Ok
        );
        assert_eq!(horus_local_map_clear_state(map), Status::Ok);
        assert_eq!(horus_local_map_clear(map), Status::Ok);
    }
    assert!(values(map).iter().all(|value| *value == UNKNOWN));
}

#[test]
fn a_cost_map_follows_a_local_map() {
    let (_memory, map) = map(&horus_local_map_config {
        has_odometry: 0,
        ..config()
    });
    let (_costs, costs) = Memory::map(&map_config(12, 9, 1, 0));
    let cells: Vec<u8> = (0..12 * 9).map(|i| [FREE, OCCUPIED, UNKNOWN][i % 3]).collect();
    // SAFETY: the handles are live, the pointers are good.
    unsafe {
        let mut shift = horus_shift { dx: 0, dy: 0 };
        let there = Pose2D::new(3.0, -1.0, 0.0);
        assert_eq!(horus_local_map_recenter(map, there, &mut shift), Status::Ok);
        assert_eq!((shift.dx, shift.dy), (24, -14));
        assert_eq!(horus_local_map_load(map, cells.as_ptr(), cells.len()), Status::Ok);
        let short = horus_local_map_load(map, cells.as_ptr(), cells.len() - 1);
        assert_eq!(short, Status::LengthMismatch);
        assert_eq!(horus_local_map_update_cost_map(map, costs), Status::Ok);
        let (mut grid, mut data, mut count) = (ptr::null(), ptr::null(), 0);
        assert_eq!(horus_cost_map_grid(costs, &mut grid), Status::Ok);
        assert_eq!(horus_grid_data(grid, &mut data, &mut count), Status::Ok);
        let followed = core::slice::from_raw_parts(data, count);
        let same = cells.iter().zip(followed).all(|(value, occupancy)| {
            *occupancy
                == match *value {
                    FREE => 0,
                    OCCUPIED => 100,
                    _ => -1,
                }
        });
        assert!(same && count == cells.len());
    }
}

#[test]
fn refused_input_leaves_a_local_map_as_it_was() {
    let (memory, map) = map(&config());
    let before = values(map);
    // SAFETY: the handle is live; what is wrong with a pointer is what is tested, none is followed.
    unsafe {
        let bad = horus_lidar_scan {
            max_range: f32::NAN,
            ..scan_of(&[1.0; 5])
        };
        assert_ne!(horus_local_map_write_scan(map, 0, &bad), Status::Ok);
        assert_ne!(
            horus_local_map_write_scan(map, 2, &scan_of(&[1.0; 5])),
            Status::Ok
        );
        assert_ne!(
            horus_local_map_write_scan(map, 0, &scan_of(&[1.0; 6])),
            Status::Ok
        );
        assert_eq!(
            horus_local_map_write_scan(map, 0, ptr::null()),
            Status::NullPointer
        );
        let nowhere = Pose2D::new(f32::NAN, 0.0, 0.0);
        assert_ne!(
            horus_local_map_recenter(map, nowhere, ptr::null_mut()),
            Status::Ok
        );
        let inside = memory.pointer().cast::<u8>().add(memory.length() - 108);
        assert_eq!(horus_local_map_load(map, inside, 108), Status::Overlap);
        let mut other = ptr::null_mut();
        let short = horus_local_map_init(memory.pointer(), 64, &config(), &mut other);
        assert_eq!(short, Status::BufferTooSmall);
        let none = horus_local_map_config {
            resolution: 0.0,
            ..config()
        };
        let mut bytes = 0;
        assert_ne!(horus_local_map_bytes(&none, &mut bytes), Status::Ok);
    }
    assert_eq!(values(map), before);
}
