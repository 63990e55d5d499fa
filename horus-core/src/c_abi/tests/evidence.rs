use core::ptr;
use std::vec;

use super::*;

/// Calls `check` with a mapping of 24 x 20 cells and a lidar of at most 8 beams.
fn with_mapping(check: impl FnOnce(*mut horus_local_mapping)) {
    let mut config = horus_local_mapping_config_default();
    config.lattice = horus_lattice_around(24, 20, 0.1);
    config.beams = 8;
    config.is_optimistic = 1;
    config.sensors[0] = horus_sensor_config_default(24, 20, 0.1);
    config.sensor_count = 1;
    config.inpaints[0] = horus_inpaint {
        frame: horus_inpaint_frame::Robot as i32,
        x0: -1.0,
        x1: -0.8,
        y0: -0.1,
        y1: 0.1,
        masses: horus_masses {
            free: 0.0,
            occupied: 1.0,
        },
    };
    config.inpaint_count = 1;
    let mut bytes = 0;
    // SAFETY: the pointers are good, the memory is as long as asked for and lives on.
    unsafe {
        assert_eq!(horus_local_mapping_bytes(&config, &mut bytes), Status::Ok);
        let fixed = HORUS_LOCAL_MAPPING_FIXED_BYTES + 6 * 24 * 20 + 4 * 20 + 8 * 8 + 12 * 24 + 8 * 22;
        assert!(bytes <= fixed.next_multiple_of(HORUS_ALIGN), "{bytes} {fixed}");
        let mut memory = vec![0u64; bytes / 8];
        let mut mapping = ptr::null_mut();
        let block = memory.as_mut_ptr().cast();
        let short = horus_local_mapping_init(block, bytes - 8, &config, &mut mapping);
        assert_eq!(short, Status::BufferTooSmall);
        config.fusion = 4;
        let choice = horus_local_mapping_init(block, bytes, &config, &mut mapping);
        assert_eq!(choice, Status::InvalidChoice);
        config.fusion = horus_fusion_operator::Pcr6 as i32;
        config.max_distance = 0.0;
        let parameter = horus_local_mapping_init(block, bytes, &config, &mut mapping);
        assert_eq!(parameter, Status::InvalidMappingParameter);
        config.max_distance = 1.0;
        config.sensors[0].m_occ.free = 0.5;
        let masses = horus_local_mapping_init(block, bytes, &config, &mut mapping);
        assert_eq!(masses, Status::InvalidMasses);
        config.sensors[0].m_occ.free = 0.0;
        config.sensor_count = 5;
        assert_eq!(
            horus_local_mapping_bytes(&config, &mut bytes),
            Status::SizeOverflow
        );
        config.sensor_count = 1;
        assert_eq!(
            horus_local_mapping_init(block, bytes, &config, &mut mapping),
            Status::Ok
        );
        check(mapping);
        drop(memory);
    }
}

#[test]
fn a_local_mapping_lives_in_the_callers_memory() {
    with_mapping(|mapping| {
        let angles = [-0.3f32, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3];
        let ranges = [0.65f32; 7];
        let scan = horus_flatscan {
            angles: angles.as_ptr(),
            ranges: ranges.as_ptr(),
            visibilities: ptr::null(),
            count: 7,
            sensor: 0,
            invalid_range_threshold: 0.05,
            out_of_range_threshold: 3.0,
        };
        let mut report = horus_tick_report::default();
        // SAFETY: the handle is live, the pointers are good.
        unsafe {
            let (mut says, mut sensor) = (9, 9);
            let status = horus_local_mapping_scan_class(mapping, 15, 10, &mut says, &mut sensor);
            assert_eq!((status, says, sensor), (Status::Ok, 0, -1), "no scan yet");
            for _ in 0..3 {
                assert_eq!(
                    horus_local_mapping_tick(mapping, &scan, HOME, &mut report),
                    Status::Ok
                );
            }
            assert_eq!(
                (report.shift, report.distance_rows_left),
                (horus_shift::default(), 0)
            );
            let (mut occupied, mut metres) = (false, 0.0);
            assert_eq!(
                horus_local_mapping_is_occupied(mapping, 18, 10, &mut occupied),
                Status::Ok
            );
            assert!(occupied, "0.65 m ahead");
            assert_eq!(
                horus_local_mapping_distance(mapping, 16, 10, &mut metres),
                Status::Ok
            );
            assert_eq!(metres, 0.2);
            let (mut cell, mut masses) = (horus_evidence_cell::default(), horus_masses::default());
            assert_eq!(
                horus_local_mapping_evidence(mapping, 15, 10, &mut cell),
                Status::Ok
            );
            assert!(cell.free > 50_000 && cell.occupied == 0, "{cell:?}");
            assert_eq!(
                horus_local_mapping_evidence(mapping, 24, 0, &mut cell),
                Status::Outside
            );
            assert_eq!(
                horus_local_mapping_masses(mapping, 3, 10, &mut masses),
                Status::Ok
            );
            assert_eq!(masses.occupied, 1.0, "painted");
            let (mut says, mut sensor) = (9, 9);
            for (row, expected) in [
                (0, horus_scan_class::Vacuous),
                (15, horus_scan_class::Free),
                (18, horus_scan_class::Occupied),
                (99, horus_scan_class::Vacuous),
            ] {
                let status = horus_local_mapping_scan_class(mapping, row, 10, &mut says, &mut sensor);
                assert_eq!((status, says, sensor), (Status::Ok, expected as i32, 0), "{row}");
            }
            let status = horus_local_mapping_scan_class(mapping, 0, 0, ptr::null_mut(), &mut sensor);
            assert_eq!(status, Status::NullPointer);
            let mut values = [0i8; 24 * 20];
            let count = values.len();
            let pointer = values.as_mut_ptr();
            assert_eq!(
                horus_local_mapping_occupancy(mapping, 0.9, pointer, 3),
                Status::LengthMismatch
            );
            assert_eq!(
                horus_local_mapping_occupancy(mapping, 0.9, pointer, count),
                Status::Ok
            );
            assert_eq!((values[0], values[10 * 24 + 3]), (-1, -1), "before painting");
            assert!(values[10 * 24 + 18] > 80);

            // Refusals.
            let robot = Pose2D::new(0.5, 0.0, 0.0);
            let refused = horus_local_map_clear(mapping.cast());
            assert_eq!(refused, Status::InvalidHandle, "a handle of another kind");
            let unknown = horus_flatscan { sensor: 1, ..scan };
            let refused = horus_local_mapping_tick(mapping, &unknown, robot, ptr::null_mut());
            assert_eq!(refused, Status::UnknownSensor);
            let empty = horus_flatscan { count: 0, ..scan };
            let refused = horus_local_mapping_tick(mapping, &empty, robot, ptr::null_mut());
            assert_eq!(refused, Status::EmptyScan);
            let missing = horus_flatscan {
                angles: ptr::null(),
                ..scan
            };
            let refused = horus_local_mapping_tick(mapping, &missing, robot, ptr::null_mut());
            assert_eq!(refused, Status::NullPointer);
            let mut info = core::mem::zeroed::<horus_map_info>();
            assert_eq!(horus_local_mapping_info(mapping, &mut info), Status::Ok);
            let at = info.offset;
            assert_eq!(horus_local_mapping_distance_info(mapping, &mut info), Status::Ok);
            assert_eq!(info.offset, at, "a whole tick leaves distances of its own window");
            assert_eq!(
                (info.width, info.height, info.offset),
                (24, 20, horus_shift::default())
            );

            // No scan, and the distances a little later.
            let status = horus_local_mapping_tick_within(mapping, ptr::null(), robot, 10, &mut report);
            assert_eq!(
                (status, report.shift.dx, report.distance_rows_left),
                (Status::Ok, 5, 29)
            );
            assert_eq!(
                horus_local_mapping_distance(mapping, 13, 10, &mut metres),
                Status::Outside
            );
            let status = horus_local_mapping_tick_within(mapping, ptr::null(), robot, 99, &mut report);
            assert_eq!((status, report.distance_rows_left), (Status::Ok, 0));
            assert_eq!(
                horus_local_mapping_distance(mapping, 11, 10, &mut metres),
                Status::Ok
            );
            assert_eq!(metres, 0.2);
        }
    });
}

#[test]
fn cells_are_fused_on_their_own() {
    let cell = |free, occupied| horus_evidence_cell { free, occupied };
    let (mut fused, mut conflict) = (cell(0, 0), 0.0);
    let total = horus_fusion_operator::DempsterShafer as i32;
    // SAFETY: the pointers are good.
    unsafe {
        let one = cell(39_321, 0); // 0.6
        let two = cell(0, 19_661); // 0.3
        assert_eq!(
            horus_evidence_fuse(0, 0.0, one, two, &mut fused, &mut conflict),
            Status::Ok
        );
        assert!(
            fused.free.abs_diff(35_389) <= 1 && fused.occupied.abs_diff(11_796) <= 1,
            "{fused:?}"
        );
        assert!((conflict - 0.18).abs() < 1e-4);
        let against = [cell(u16::MAX, 0), cell(0, u16::MAX)];
        let status = horus_evidence_fuse(total, 0.0, against[0], against[1], &mut fused, ptr::null_mut());
        assert_eq!((status, fused), (Status::Ok, cell(0, 0)));
        let broken = cell(u16::MAX, 1);
        let status = horus_evidence_fuse(0, 0.0, one, broken, &mut fused, ptr::null_mut());
        assert_eq!(status, Status::InvalidMasses);
        let status = horus_evidence_fuse(9, 0.0, one, two, &mut fused, ptr::null_mut());
        assert_eq!(status, Status::InvalidChoice);
        let status = horus_evidence_fuse(0, 1.0, one, two, &mut fused, ptr::null_mut());
        assert_eq!(status, Status::InvalidMappingParameter);
    }
}
