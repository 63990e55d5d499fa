//! What the interface can see is refused; that nothing invalid is touched, miri sees.

use core::ptr;
use std::ffi::CStr;

use super::*;

#[test]
fn memory_must_be_there_aligned_long_enough_and_apart() {
    let config = grid_config(5, 5);
    let (memory, grid) = Memory::grid(&config);
    let (at, length) = (memory.pointer(), memory.length());
    let mut made = ptr::null_mut();
    // SAFETY: the memory is as long as said, and every other pointer is good or must be refused.
    unsafe {
        let null = horus_grid_init(ptr::null_mut(), length, &config, &mut made);
        assert_eq!(null, Status::NullPointer);
        let misaligned = horus_grid_init(at.byte_add(4), length - 4, &config, &mut made);
        assert_eq!(misaligned, Status::Misaligned);
        let short = horus_grid_init(at, length - 1, &config, &mut made);
        assert_eq!(short, Status::BufferTooSmall);
        let fresh = Memory::new(length);
        fresh.pointer().cast::<horus_grid_config>().write(config);
        let inside = horus_grid_init(fresh.pointer(), length, fresh.pointer().cast(), &mut made);
        assert_eq!(inside, Status::Overlap);
        let onto = horus_grid_init(at, length, &config, at.cast());
        assert_eq!(onto, Status::Overlap);
        assert!(made.is_null());
        assert_eq!(
            horus_grid_clear(grid),
            Status::Ok,
            "a refused init leaves the object alone"
        );
    }
}

#[test]
fn sizes_beyond_the_address_space_are_refused() {
    let mut bytes = 1;
    // SAFETY: the pointers are good.
    unsafe {
        let wide = grid_config(1 << 31, 1);
        assert_eq!(horus_grid_bytes(&wide, &mut bytes), Status::SizeOverflow);
        let many = map_config(1 << 30, 1 << 30, 2, 1);
        let status = horus_cost_map_bytes(&many, &mut bytes);
        assert_eq!(status, Status::SizeOverflow);
        let (_memory, map) = Memory::map(&map_config(2, 2, 1, 0));
        let (vertex, mut under) = (horus_point::default(), core::mem::zeroed());
        let status = horus_cost_map_footprint_cost(map, HOME, &vertex, usize::MAX / 2, &mut under);
        assert_eq!(status, Status::SizeOverflow);
    }
}

#[test]
fn only_objects_of_the_kind_are_taken() {
    let (memory, map) = Memory::map(&map_config(4, 4, 1, 0));
    let (_other, grid) = Memory::grid(&grid_config(4, 4));
    let nothing = [0u64; 8];
    let copy = Memory::new(memory.length());
    // SAFETY: everything handed over is readable.
    unsafe {
        assert_eq!(horus_cost_map_compute(ptr::null_mut()), Status::NullPointer);
        assert_eq!(horus_cost_map_compute(map.byte_add(4)), Status::Misaligned);
        assert_eq!(horus_cost_map_compute(grid.cast()), Status::InvalidHandle);
        let zeros = nothing.as_ptr().cast_mut().cast();
        assert_eq!(horus_cost_map_compute(zeros), Status::InvalidHandle);
        let mut free = false;
        assert_eq!(
            horus_grid_is_free(zeros.cast(), 0.0, 0.0, &mut free),
            Status::InvalidHandle
        );
        copy.pointer().copy_from(memory.pointer(), memory.length());
        assert_eq!(
            horus_cost_map_compute(copy.pointer().cast()),
            Status::InvalidHandle
        );
    }
}

#[test]
fn a_failed_init_leaves_no_object() {
    let mut config = map_config(4, 4, 1, 0);
    let (memory, map) = Memory::map(&config);
    config.params.inflation_radius = 3.0;
    config.params.cost_scaling_factor = 0.5;
    let mut made = ptr::null_mut();
    // SAFETY: the pointers are good.
    unsafe {
        let status = horus_cost_map_init(memory.pointer(), memory.length(), &config, &mut made);
        assert_eq!(status, Status::RadiusTooLarge);
        assert!(made.is_null());
        assert_eq!(horus_cost_map_compute(map), Status::InvalidHandle);
    }
}

#[test]
fn arrays_must_be_aligned_and_apart() {
    let (memory, map) = Memory::map(&map_config(8, 8, 1, 1));
    let (beams, lidar) = Memory::workspace(4, 0);
    let floats = [0.5f32; 8];
    let mut scan = scan_of(&floats[..4]);
    let model = horus_scan_model_set();
    // SAFETY: everything handed over is readable and, where written, writable.
    unsafe {
        let run = |scan: *const horus_laser_scan, report: *mut horus_scan_report| {
            horus_cost_map_integrate_scan(map, scan, HOME, model, lidar, report)
        };
        assert_eq!(run(&scan, memory.pointer().cast()), Status::Overlap);
        assert_eq!(run(&scan, beams.pointer().cast()), Status::Overlap);
        assert_eq!(run(&scan, (&raw mut scan).cast()), Status::Overlap);
        assert_eq!(run(ptr::null(), ptr::null_mut()), Status::NullPointer);
        assert_eq!(run(memory.pointer().cast(), ptr::null_mut()), Status::Overlap);
        scan.ranges = floats.as_ptr().byte_add(1);
        assert_eq!(run(&scan, ptr::null_mut()), Status::Misaligned);
        scan.ranges = beams.pointer().cast();
        assert_eq!(run(&scan, ptr::null_mut()), Status::Overlap);
        scan.ranges = ptr::null();
        assert_eq!(run(&scan, ptr::null_mut()), Status::NullPointer);
        scan.count = 0;
        assert_eq!(run(&scan, ptr::null_mut()), Status::Ok);

        // The object's own bytes, on their way in and out.
        let (mut costs, mut count) = (ptr::null(), 0);
        assert_eq!(horus_cost_map_costs(map, &mut costs, &mut count), Status::Ok);
        assert_eq!(horus_cost_map_load(map, costs.cast(), count), Status::Overlap);
        assert_eq!(horus_cost_map_row(map, 0, costs.cast_mut(), 8), Status::Overlap);
        let both = (&raw mut count).cast();
        assert_eq!(horus_cost_map_costs(map, both, &mut count), Status::Overlap);
    }
}

#[test]
fn numbers_that_name_nothing_are_refused() {
    let mut bytes = 0;
    // SAFETY: the pointers are good.
    unsafe {
        for (field_bytes, decay) in [(0, 0), (3, 0), (255, 1), (1, 2), (2, i32::MIN)] {
            let mut config = map_config(4, 4, field_bytes, 0);
            config.params.decay = decay;
            assert_eq!(horus_cost_map_bytes(&config, &mut bytes), Status::InvalidChoice);
        }
        let (_memory, grid) = Memory::grid(&grid_config(4, 4));
        let (_beams, lidar) = Memory::workspace(1, 16);
        let ranges = [0.1];
        let mut model = horus_scan_model_accumulate();
        model.kind = 7;
        let status = horus_grid_integrate_scan(grid, &scan_of(&ranges), HOME, model, lidar, ptr::null_mut());
        assert_eq!(status, Status::InvalidChoice);
        let invalid = [0xc3u8, 0x28];
        let status = horus_grid_set_header(grid, invalid.as_ptr().cast(), 2, 0);
        assert_eq!(status, Status::InvalidText);
    }
}

#[test]
fn every_number_has_a_text() {
    let mut seen = std::collections::BTreeSet::new();
    for status in -1..40 {
        // SAFETY: texts are static.
        let text = unsafe { CStr::from_ptr(horus_status_text(status)) };
        seen.insert(text.to_str().unwrap());
    }
    assert_eq!(seen.len(), 37 + 1, "{seen:?}");
    assert_eq!(horus_abi_version(), HORUS_ABI_VERSION);
}
