//! Reading a grid, or the one inside a cost map.

use core::ffi::c_char;

use super::call::{Call, Claims};
use super::cost_map::AnyCostMap;
use super::geometry::{horus_cell, horus_point};
use super::grid::{Grid, horus_grid, horus_map_info};
use super::status::{horus_status, inside};
use super::text;

/// A grid to be read: one of its own, or the one inside a cost map.
pub(super) fn view<'c>(claims: &mut Claims<'c>, grid: *const horus_grid) -> Result<&'c Grid, horus_status> {
    match claims.object::<Grid>(grid) {
        Err(horus_status::InvalidHandle) => Ok(claims.object::<AnyCostMap>(grid.cast())?.grid()),
        own => own,
    }
}

/// Size, resolution and place of the grid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_info(grid: *const horus_grid, info: *mut horus_map_info) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let grid = view(claims, grid)?;
        claims.output(info)?.write(grid.info().into());
        Ok(())
    })
}

/// All cells, row by row: *count = width * height values at *data, to be read until the next call
/// that changes the grid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_data(
    grid: *const horus_grid,
    data: *mut *const i8,
    count: *mut usize,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let cells = view(claims, grid)?.data();
        let (data, count) = (claims.output(data)?, claims.output(count)?);
        data.write(cells.as_ptr());
        count.write(cells.len());
        Ok(())
    })
}

/// The value of a cell.
///
/// Fails with HORUS_STATUS_OUTSIDE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_occupancy(
    grid: *const horus_grid,
    gx: u32,
    gy: u32,
    value: *mut i8,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let grid = view(claims, grid)?;
        let value = claims.output(value)?;
        value.write(inside(grid.occupancy(gx, gy))?);
        Ok(())
    })
}

/// Whether the world point lies in a cell with a value of 0 .. 49; not if unknown or outside.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_is_free(
    grid: *const horus_grid,
    x: f32,
    y: f32,
    free: *mut bool,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let grid = view(claims, grid)?;
        claims.output(free)?.write(grid.is_free(x, y));
        Ok(())
    })
}

/// Whether the world point lies in a cell with a value of 50 .. 100; not if unknown or outside.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_is_occupied(
    grid: *const horus_grid,
    x: f32,
    y: f32,
    occupied: *mut bool,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let grid = view(claims, grid)?;
        claims.output(occupied)?.write(grid.is_occupied(x, y));
        Ok(())
    })
}

/// The cell that holds a world point; one on a boundary belongs to the upper cell.
///
/// Fails with HORUS_STATUS_OUTSIDE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_world_to_grid(
    grid: *const horus_grid,
    x: f32,
    y: f32,
    cell: *mut horus_cell,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let grid = view(claims, grid)?;
        let cell = claims.output(cell)?;
        let (gx, gy) = inside(grid.world_to_grid(x, y))?;
        cell.write(horus_cell { gx, gy });
        Ok(())
    })
}

/// The world point at the centre of a cell.
///
/// Fails with HORUS_STATUS_OUTSIDE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_grid_to_world(
    grid: *const horus_grid,
    gx: u32,
    gy: u32,
    point: *mut horus_point,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let grid = view(claims, grid)?;
        let point = claims.output(point)?;
        let (x, y) = inside(grid.grid_to_world(gx, gy))?;
        point.write(horus_point { x, y });
        Ok(())
    })
}

/// The frame's name with its terminating zero, into a text of `length` bytes: 33 suffice.
///
/// Fails with HORUS_STATUS_BUFFER_TOO_SMALL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_frame_id(
    grid: *const horus_grid,
    frame_id: *mut c_char,
    length: usize,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let grid = view(claims, grid)?;
        text::output(claims, frame_id, length, grid.frame_id_str())
    })
}

/// The free-form text with its terminating zero, into a text of `length` bytes: 65 suffice.
///
/// Fails with HORUS_STATUS_BUFFER_TOO_SMALL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_metadata(
    grid: *const horus_grid,
    metadata: *mut c_char,
    length: usize,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let grid = view(claims, grid)?;
        text::output(claims, metadata, length, grid.metadata_str())
    })
}

/// The grid's time in nanoseconds.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_timestamp(
    grid: *const horus_grid,
    timestamp_ns: *mut u64,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let grid = view(claims, grid)?;
        claims.output(timestamp_ns)?.write(grid.timestamp_ns);
        Ok(())
    })
}
