use core::ptr;
use std::ffi::CStr;

use super::*;

#[test]
fn a_grid_lives_in_the_callers_memory() {
    let (memory, grid) = Memory::grid(&grid_config(12, 9));
    let (_beams, lidar) = Memory::workspace(8, 12 * 9);
    assert_eq!(grid.addr(), memory.pointer().addr());
    // SAFETY: the handles are live, the pointers are good.
    unsafe {
        let middle = Pose2D::new(0.6, 0.45, 0.0);
        let ranges = [0.4, 5.0, f32::NAN, 0.3, f32::INFINITY, 0.5, 0.2, 0.35];
        let scan = scan_of(&ranges);
        let mut report = core::mem::zeroed::<horus_scan_report>();
        for model in [horus_scan_model_accumulate(), horus_scan_model_set()] {
            let status = horus_grid_integrate_scan(grid, &scan, middle, model, lidar, &mut report);
            assert_eq!(status, Status::Ok);
            assert_eq!((report.hits, report.misses, report.ignored), (5, 2, 1));
            assert!(report.changed.width() > 0);
        }
        let (mut free, mut occupied) = (false, false);
        assert_eq!(horus_grid_is_free(grid, 0.75, 0.45, &mut free), Status::Ok);
        assert_eq!(horus_grid_is_occupied(grid, 1.0, 0.45, &mut occupied), Status::Ok);
        assert!(free && occupied);

        let mut shift = horus_shift::default();
        let east = Pose2D::new(0.9, 0.45, 0.0);
        assert_eq!(horus_grid_recenter(grid, east, &mut shift), Status::Ok);
        assert_eq!(shift, horus_shift { dx: 3, dy: 0 });
        let mut info = core::mem::zeroed::<horus_map_info>();
        assert_eq!(horus_grid_info(grid, &mut info), Status::Ok);
        assert_eq!((info.width, info.height, info.offset), (12, 9, shift));

        let (mut data, mut count) = (ptr::null(), 0);
        assert_eq!(horus_grid_set_occupancy(grid, 11, 8, 127), Status::Ok);
        assert_eq!(horus_grid_data(grid, &mut data, &mut count), Status::Ok);
        assert_eq!((count, *data.add(count - 1)), (12 * 9, 100));
    }
}

#[test]
fn a_grid_takes_a_smaller_size_in_place_and_a_load() {
    let (_memory, grid) = Memory::grid(&grid_config(6, 5));
    // SAFETY: the handle is live, the pointers are good.
    unsafe {
        assert_eq!(horus_grid_reset(grid, &grid_config(6, 6)), Status::BufferTooSmall);
        assert_eq!(horus_grid_reset(grid, &grid_config(4, 3)), Status::Ok);
        let values = [7i8; 12];
        assert_eq!(horus_grid_load(grid, values.as_ptr(), 30), Status::LengthMismatch);
        assert_eq!(horus_grid_load(grid, values.as_ptr(), 12), Status::Ok);
        let mut value = 0;
        assert_eq!(horus_grid_occupancy(grid, 3, 2, &mut value), Status::Ok);
        assert_eq!(value, 7);
        assert_eq!(horus_grid_clear(grid), Status::Ok);
        assert_eq!(horus_grid_occupancy(grid, 3, 2, &mut value), Status::Ok);
        assert_eq!(value, -1);
        assert_eq!(horus_grid_occupancy(grid, 4, 2, &mut value), Status::Outside);
    }
}

#[test]
fn texts_and_points_cross_the_interface() {
    let (_memory, grid) = Memory::grid(&grid_config(6, 5));
    let (name, note) = ("map_ä", "first floor");
    // SAFETY: the handle is live, the pointers are good.
    unsafe {
        let status = horus_grid_set_header(grid, name.as_ptr().cast(), name.len(), 77);
        assert_eq!(status, Status::Ok);
        assert_eq!(
            horus_grid_set_metadata(grid, note.as_ptr().cast(), note.len()),
            Status::Ok
        );
        let mut text = [1; 65];
        assert_eq!(horus_grid_frame_id(grid, text.as_mut_ptr(), 33), Status::Ok);
        assert_eq!(CStr::from_ptr(text.as_ptr()).to_str(), Ok(name));
        assert_eq!(horus_grid_metadata(grid, text.as_mut_ptr(), 12), Status::Ok);
        assert_eq!(CStr::from_ptr(text.as_ptr()).to_str(), Ok(note));
        assert_eq!(text[12], 1, "nothing behind the zero");
        let mut time = 0;
        assert_eq!(horus_grid_timestamp(grid, &mut time), Status::Ok);
        assert_eq!(time, 77);

        let (mut cell, mut point) = (horus_cell::default(), horus_point::default());
        assert_eq!(horus_grid_world_to_grid(grid, 0.25, 0.3, &mut cell), Status::Ok);
        assert_eq!(cell, horus_cell { gx: 2, gy: 3 });
        assert_eq!(horus_grid_grid_to_world(grid, 2, 3, &mut point), Status::Ok);
        assert_eq!(point, horus_point { x: 0.25, y: 0.35 });
        assert_eq!(
            horus_grid_world_to_grid(grid, f32::NAN, 0.0, &mut cell),
            Status::Outside
        );
    }
}
