use core::ffi::c_void;

use super::map::{distance_map, horus_distance_map};
use crate::c_abi::call::Call;
use crate::c_abi::geometry::horus_cell;
use crate::c_abi::grid::horus_grid;
use crate::c_abi::grid_reads::view;
use crate::c_abi::status::{horus_status, inside};
use crate::geometry::CellRect;

/// The cells whose distances are, or are being, computed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_distance_map_window(
    map: *const horus_distance_map,
    window: *mut CellRect,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = distance_map(claims, map)?;
        claims.output(window)?.write(map.window());
        Ok(())
    })
}

/// The squared distance of a cell of the grid, in cells.
///
/// Fails with HORUS_STATUS_OUTSIDE outside the window, and while a computation has not ended.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_distance_map_squared(
    map: *const horus_distance_map,
    gx: u32,
    gy: u32,
    squared: *mut i64,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = distance_map(claims, map)?;
        let squared = claims.output(squared)?;
        squared.write(inside(map.squared_at(gx, gy))?);
        Ok(())
    })
}

/// The distance of a cell of the grid in metres.
///
/// Fails with HORUS_STATUS_OUTSIDE outside the window, and while a computation has not ended.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_distance_map_metres(
    map: *const horus_distance_map,
    gx: u32,
    gy: u32,
    metres: *mut f32,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = distance_map(claims, map)?;
        let metres = claims.output(metres)?;
        metres.write(inside(map.metres_at(gx, gy))?);
        Ok(())
    })
}

/// All squared distances of the window, row by row, in the type that the map was made with
/// (uint16_t, int16_t, uint32_t, int32_t): *count cells at *data, to be read until the map is
/// computed anew; none while a computation has not ended.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_distance_map_data(
    map: *const horus_distance_map,
    data: *mut *const c_void,
    count: *mut usize,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let (cells, number) = distance_map(claims, map)?.data();
        let (data, count) = (claims.output(data)?, claims.output(count)?);
        data.write(cells);
        count.write(number);
        Ok(())
    })
}

/// The obstacle nearest to a cell, of several the one with the lowest index; `grid` is the one that
/// the distances were computed of.
///
/// Fails with HORUS_STATUS_OUTSIDE outside the window, while a computation has not ended, and where
/// no obstacle lies within the cap.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_distance_map_nearest(
    map: *const horus_distance_map,
    grid: *const horus_grid,
    gx: u32,
    gy: u32,
    nearest: *mut horus_cell,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = distance_map(claims, map)?;
        let grid = view(claims, grid)?;
        let nearest = claims.output(nearest)?;
        let (gx, gy) = inside(map.nearest_obstacle(grid, gx, gy))?;
        nearest.write(horus_cell { gx, gy });
        Ok(())
    })
}
