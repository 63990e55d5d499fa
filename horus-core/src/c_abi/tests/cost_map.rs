use core::ptr;
use std::vec::Vec;

use super::*;

const SIDE: u32 = 14;

/// Every cost, through the map.
unsafe fn costs(map: *const horus_cost_map) -> Vec<u8> {
    let mut costs = Vec::new();
    for gy in 0..SIDE {
        let mut row = [0; SIDE as usize];
        // SAFETY: the caller's handle is live.
        let status = unsafe { horus_cost_map_row(map, gy, row.as_mut_ptr(), row.len()) };
        assert_eq!(status, Status::Ok);
        costs.extend(row);
    }
    costs
}

/// Scans, edits and shifts a map, updated as `update` does, and compares it with a full recompute.
unsafe fn drive(field_bytes: u8, keep: u8, mut update: impl FnMut(*mut horus_cost_map)) {
    let (_memory, map) = Memory::map(&map_config(SIDE, SIDE, field_bytes, keep));
    let (_beams, lidar) = Memory::workspace(6, SIDE * SIDE);
    let ranges = [0.3, 0.5, 0.2, 9.0, 0.4, f32::NAN];
    let scan = scan_of(&ranges);
    for tick in 0..4u8 {
        let pose = Pose2D::new(0.7 + 0.2 * f32::from(tick), 0.7, 0.5 * f32::from(tick));
        let model = if tick < 2 {
            horus_scan_model_set()
        } else {
            horus_scan_model_accumulate()
        };
        // SAFETY: the handles are live, the pointers are good.
        unsafe {
            assert_eq!(horus_cost_map_recenter(map, pose, ptr::null_mut()), Status::Ok);
            let status = horus_cost_map_integrate_scan(map, &scan, pose, model, lidar, ptr::null_mut());
            assert_eq!(status, Status::Ok);
            let edited = horus_cost_map_set_occupancy(map, 3, u32::from(tick), 100);
            assert_eq!(edited, Status::Ok);
            update(map);
            let kept = read_kept(map);
            let incremental = costs(map);
            assert_eq!(kept.is_some(), keep != 0);
            assert_eq!(kept.unwrap_or(incremental.clone()), incremental);
            assert_eq!(horus_cost_map_compute(map), Status::Ok);
            assert_eq!(costs(map), incremental, "tick {tick}");
        }
    }
}

unsafe fn read_kept(map: *const horus_cost_map) -> Option<Vec<u8>> {
    let (mut bytes, mut count) = (ptr::null(), 0);
    // SAFETY: the caller's handle is live; the bytes are read before the next change.
    unsafe {
        match horus_cost_map_costs(map, &mut bytes, &mut count) {
            Status::NotKept => None,
            status => {
                assert_eq!(status, Status::Ok);
                Some((0..count).map(|i| *bytes.add(i)).collect())
            }
        }
    }
}

fn update_at_once(map: *mut horus_cost_map) {
    let mut changed = CellRect {
        x0: 9,
        y0: 9,
        x1: 9,
        y1: 9,
    };
    // SAFETY: the handle is live, the pointer is good.
    assert_eq!(unsafe { horus_cost_map_update(map, &mut changed) }, Status::Ok);
    assert!(changed.x1 <= SIDE && changed.width() > 0);
}

fn update_in_steps(map: *mut horus_cost_map) {
    // SAFETY: the handle is live, the pointers are good.
    unsafe {
        let (mut budget, mut calls, mut pending) = (0, 0, 0);
        assert_eq!(horus_cost_map_min_budget(map, &mut budget), Status::Ok);
        assert_eq!(horus_cost_map_calls_left(map, &mut calls), Status::Ok);
        let mut update = core::mem::zeroed::<horus_cost_update>();
        let refused = horus_cost_map_update_within(map, budget - 1, &mut update);
        assert_eq!(refused, Status::BudgetTooSmall);
        loop {
            assert!(calls > 0, "more calls than were announced");
            assert_eq!(horus_cost_map_update_within(map, budget, &mut update), Status::Ok);
            assert_eq!(horus_cost_map_pending(map, &mut pending), Status::Ok);
            assert_eq!(pending, update.pending);
            if pending == 0 {
                return;
            }
            calls -= 1;
        }
    }
}

#[test]
fn a_one_byte_map_follows_its_cells() {
    // SAFETY: `drive` gives live handles.
    unsafe { drive(1, 0, update_at_once) };
}

#[test]
fn a_one_byte_map_with_kept_costs_follows_in_steps() {
    // SAFETY: `drive` gives live handles.
    unsafe { drive(1, 1, update_in_steps) };
}

#[test]
fn a_two_byte_map_with_kept_costs_follows_its_cells() {
    // SAFETY: `drive` gives live handles.
    unsafe { drive(2, 1, update_at_once) };
}

#[test]
fn a_map_shows_its_grid_and_takes_parameters() {
    let (_memory, map) = Memory::map(&map_config(SIDE, SIDE, 1, 0));
    // SAFETY: the handle is live, the pointers are good.
    unsafe {
        let frame = "odom";
        let status = horus_cost_map_set_header(map, frame.as_ptr().cast(), frame.len(), 5);
        assert_eq!(status, Status::Ok);
        let (mut grid, mut time) = (ptr::null(), 0);
        assert_eq!(horus_cost_map_grid(map, &mut grid), Status::Ok);
        assert_eq!(horus_grid_timestamp(grid, &mut time), Status::Ok);
        assert_eq!(time, 5);
        assert_eq!(horus_grid_clear(grid.cast_mut()), Status::InvalidHandle);

        let mut values = [0i8; (SIDE * SIDE) as usize];
        values[0] = 100;
        assert_eq!(
            horus_cost_map_load(map, values.as_ptr(), values.len()),
            Status::Ok
        );
        let mut params = horus_cost_params_horus();
        assert_eq!(
            horus_cost_map_set_params(map, &horus_cost_params_nav2()),
            Status::Ok
        );
        assert_eq!(horus_cost_map_params(map, &mut params), Status::Ok);
        assert_eq!(params, horus_cost_params_nav2());
        let (mut radius, mut cost) = (0, 0);
        assert_eq!(horus_cost_map_effective_radius(map, &mut radius), Status::Ok);
        assert_eq!(horus_cost_map_cost_at(map, 0, 0, &mut cost), Status::Ok);
        assert_eq!((radius, cost), (6, 254));
        assert_eq!(horus_cost_map_cost(map, 0.15, 0.05, &mut cost), Status::Ok);
        assert_eq!(cost, 253);

        let outline = [(0.0, 0.0), (0.4, 0.0), (0.4, 0.4)].map(|(x, y)| horus_point { x, y });
        let mut under = core::mem::zeroed::<horus_footprint_cost>();
        let status = horus_cost_map_footprint_cost(map, HOME, outline.as_ptr(), 3, &mut under);
        assert_eq!(status, Status::Ok);
        assert_eq!((under.cost, under.leaves_map), (254, false));
    }
}

#[test]
fn the_narrow_functions_make_one_kind_each() {
    let config = map_config(4, 4, 1, 0);
    let (memory, _) = Memory::map(&config);
    let mut map = ptr::null_mut();
    // SAFETY: the pointers are good.
    unsafe {
        let (at, length) = (memory.pointer(), memory.length());
        let status = horus_cost_map_init_2(at, length, &config, &mut map);
        assert_eq!(status, Status::InvalidChoice);
        assert_eq!(horus_cost_map_init_1(at, length, &config, &mut map), Status::Ok);
        assert_eq!(horus_cost_map_compute(map), Status::Ok);
    }
}
