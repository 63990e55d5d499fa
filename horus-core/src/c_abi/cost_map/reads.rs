//! Reading a cost map.

use super::horus_cost_map;
use super::map::cost_map;
use crate::c_abi::call::Call;
use crate::c_abi::geometry::horus_point;
use crate::c_abi::grid::horus_grid;
use crate::c_abi::status::{horus_status, inside};
use crate::geometry::Pose2D;

/// What lies under a polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct horus_footprint_cost {
    /// The highest known cost, 0 .. 254; -1 if no cell under the polygon is known.
    pub cost: i32,
    /// A cell under the polygon is unknown.
    pub touches_unknown: bool,
    /// Part of the polygon lies outside the map.
    pub leaves_map: bool,
}

/// The grid inside, for the functions that read one: a handle that lives as long as the map's.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_grid(
    map: *const horus_cost_map,
    grid: *mut *const horus_grid,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        cost_map(claims, map)?;
        // Functions that read a grid know a cost map by its tag, those that write one refuse it.
        claims.output(grid)?.write(map.cast());
        Ok(())
    })
}

/// The cost at a world point.
///
/// Fails with HORUS_STATUS_OUTSIDE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_cost(
    map: *const horus_cost_map,
    x: f32,
    y: f32,
    cost: *mut u8,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = cost_map(claims, map)?;
        let cost = claims.output(cost)?;
        cost.write(inside(map.cost(x, y))?);
        Ok(())
    })
}

/// The cost of a cell.
///
/// Fails with HORUS_STATUS_OUTSIDE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_cost_at(
    map: *const horus_cost_map,
    gx: u32,
    gy: u32,
    cost: *mut u8,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = cost_map(claims, map)?;
        let cost = claims.output(cost)?;
        cost.write(inside(map.cost_at(gx, gy))?);
        Ok(())
    })
}

/// Copies the costs of a row into `costs`, which has room for `length` bytes: its width suffices.
///
/// Fails with HORUS_STATUS_OUTSIDE, HORUS_STATUS_BUFFER_TOO_SMALL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_row(
    map: *const horus_cost_map,
    gy: u32,
    costs: *mut u8,
    length: usize,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = cost_map(claims, map)?;
        let info = map.grid().info();
        inside((gy < info.height()).then_some(()))?;
        let width = info.width() as usize;
        if length < width {
            return Err(horus_status::BufferTooSmall);
        }
        let to = claims.slice_mut(costs, width)?;
        map.copy_row(gy, to);
        Ok(())
    })
}

/// The kept costs as of the last update, row by row: *count = width * height bytes at *costs, to be
/// read until the next call that changes the map.
///
/// Fails with HORUS_STATUS_NOT_KEPT.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_costs(
    map: *const horus_cost_map,
    costs: *mut *const u8,
    count: *mut usize,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = cost_map(claims, map)?;
        let (to, count) = (claims.output(costs)?, claims.output(count)?);
        let costs = map.costs().ok_or(horus_status::NotKept)?;
        to.write(costs.as_ptr());
        count.write(costs.len());
        Ok(())
    })
}

/// The highest known cost under a polygon, and whether it touches unknown cells or leaves the map.
/// The vertices lie in the frame of `pose`, which lies in the world frame.
///
/// Fails with HORUS_STATUS_NON_FINITE_POSE, HORUS_STATUS_INVALID_POLYGON.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_footprint_cost(
    map: *const horus_cost_map,
    pose: Pose2D,
    vertices: *const horus_point,
    count: usize,
    under: *mut horus_footprint_cost,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = cost_map(claims, map)?;
        let vertices = claims.slice(vertices, count)?;
        let to = claims.output(under)?;
        let under = map.footprint_cost(pose, vertices)?;
        to.write(horus_footprint_cost {
            cost: under.cost.map_or(-1, i32::from),
            touches_unknown: under.touches_unknown,
            leaves_map: under.leaves_map,
        });
        Ok(())
    })
}
