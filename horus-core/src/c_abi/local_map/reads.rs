use super::map::{LocalMap, horus_local_map};
use crate::c_abi::call::Call;
use crate::c_abi::geometry::{horus_cell, horus_point};
use crate::c_abi::grid::horus_map_info;
use crate::c_abi::status::{horus_status, inside};
use crate::geometry::Pose2D;

/// A map that was published.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct horus_grid_map_view {
    /// All cells, row by row, to be read until the map is next changed.
    pub data: *const u8,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Metres per cell.
    pub resolution: f32,
    /// The corner of cell (0, 0) in the map's frame.
    pub origin: horus_point,
}

/// Size, resolution and place of the local map.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_map_info(
    map: *const horus_local_map,
    info: *mut horus_map_info,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let local = claims.object::<LocalMap>(map)?;
        claims.output(info)?.write(local.map.info().into());
        Ok(())
    })
}

/// All cells, row by row: *count = width * height bytes at *data, to be read until the next call that
/// changes the map.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_map_data(
    map: *const horus_local_map,
    data: *mut *const u8,
    count: *mut usize,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let cells = claims.object::<LocalMap>(map)?.map.data();
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
pub unsafe extern "C" fn horus_local_map_value(
    map: *const horus_local_map,
    gx: u32,
    gy: u32,
    value: *mut u8,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let local = claims.object::<LocalMap>(map)?;
        let value = claims.output(value)?;
        value.write(inside(local.map.value(gx, gy))?);
        Ok(())
    })
}

/// The cell that holds a point of the map's frame.
///
/// Fails with HORUS_STATUS_OUTSIDE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_map_cell_at(
    map: *const horus_local_map,
    x: f32,
    y: f32,
    cell: *mut horus_cell,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let local = claims.object::<LocalMap>(map)?;
        let cell = claims.output(cell)?;
        let (gx, gy) = inside(local.map.cell_at(x, y))?;
        cell.write(horus_cell { gx, gy });
        Ok(())
    })
}

/// The transformation from the map's frame to the world as of the last update.
///
/// Fails with HORUS_STATUS_NOT_FOUND before the first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_map_transformation(
    map: *const horus_local_map,
    transformation: *mut Pose2D,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let local = claims.object::<LocalMap>(map)?;
        let to = claims.output(transformation)?;
        to.write(local.map.transformation().ok_or(horus_status::NotFound)?);
        Ok(())
    })
}

/// What was last published.
///
/// Fails with HORUS_STATUS_NOT_FOUND if nothing was.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_map_read_gridmap(
    map: *const horus_local_map,
    view: *mut horus_grid_map_view,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let local = claims.object::<LocalMap>(map)?;
        let to = claims.output(view)?;
        let found = local.map.read_gridmap(&local.state);
        let found = found.ok_or(horus_status::NotFound)?;
        let [x, y] = found.origin;
        to.write(horus_grid_map_view {
            data: found.data.as_ptr(),
            width: found.width,
            height: found.height,
            resolution: found.resolution,
            origin: horus_point { x, y },
        });
        Ok(())
    })
}

/// The transformation that was last published.
///
/// Fails with HORUS_STATUS_NOT_FOUND if none was.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_map_read_transformation(
    map: *const horus_local_map,
    transformation: *mut Pose2D,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let local = claims.object::<LocalMap>(map)?;
        let to = claims.output(transformation)?;
        let found = local.map.read_transformation(&local.state);
        to.write(found.ok_or(horus_status::NotFound)?);
        Ok(())
    })
}
