//! Changing the cells of a cost map.

use core::ffi::c_char;

use super::horus_cost_map;
use super::map::cost_map_mut;
use crate::c_abi::call::Call;
use crate::c_abi::geometry::horus_shift;
use crate::c_abi::grid::one_per_cell;
use crate::c_abi::scan::{
    ScanCall, horus_laser_scan, horus_scan_model, horus_scan_report, horus_scan_workspace,
};
use crate::c_abi::status::{horus_status, inside};
use crate::c_abi::text;
use crate::geometry::Pose2D;

/// Sets a cell, clamped to -1 .. 100; its costs follow with the next update.
///
/// Fails with HORUS_STATUS_OUTSIDE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_set_occupancy(
    map: *mut horus_cost_map,
    gx: u32,
    gy: u32,
    value: i8,
) -> horus_status {
    // SAFETY: the pointer is the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = cost_map_mut(claims, map)?;
        inside(map.set_occupancy(gx, gy, value).then_some(()))
    })
}

/// Integrates a scan as horus_grid_integrate_scan() does; costs follow with the next update.
///
/// Fails as it does.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_integrate_scan(
    map: *mut horus_cost_map,
    scan: *const horus_laser_scan,
    sensor_pose: Pose2D,
    model: horus_scan_model,
    workspace: *mut horus_scan_workspace,
    report: *mut horus_scan_report,
) -> horus_status {
    let call = ScanCall {
        scan,
        model,
        workspace,
        report,
    };
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = cost_map_mut(claims, map)?;
        call.run(claims, |scan, model, workspace| {
            map.integrate_scan(scan, sensor_pose, model, workspace)
        })
    })
}

/// Moves the window as horus_grid_recenter() does; costs move with their cells.
///
/// Fails as it does.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_recenter(
    map: *mut horus_cost_map,
    pose: Pose2D,
    shift: *mut horus_shift,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = cost_map_mut(claims, map)?;
        let shift = claims.output_or_null(shift)?;
        shift.write(map.recenter(pose)?.into());
        Ok(())
    })
}

/// Replaces all cells, row by row, each clamped to -1 .. 100, and recomputes everything.
///
/// Fails with HORUS_STATUS_LENGTH_MISMATCH unless count is width * height.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_load(
    map: *mut horus_cost_map,
    values: *const i8,
    count: usize,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = cost_map_mut(claims, map)?;
        let values = one_per_cell(claims, map.grid(), values, count)?;
        map.load(values)?;
        Ok(())
    })
}

/// Names the frame (UTF-8, at most 32 bytes are kept) and sets the time, in nanoseconds.
///
/// Fails with HORUS_STATUS_INVALID_TEXT.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_set_header(
    map: *mut horus_cost_map,
    frame_id: *const c_char,
    length: usize,
    timestamp_ns: u64,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = cost_map_mut(claims, map)?;
        let frame_id = text::input(claims, frame_id, length)?;
        map.set_header(frame_id, timestamp_ns);
        Ok(())
    })
}
