//! Bringing the costs up to date.

use super::horus_cost_map;
use super::map::{cost_map, cost_map_mut};
use crate::c_abi::call::Call;
use crate::c_abi::geometry::rect_or_empty;
use crate::c_abi::status::horus_status;
use crate::geometry::CellRect;

/// What a budgeted update did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct horus_cost_update {
    /// Every cost that differs from before the call lies in here; all zero if none does.
    pub changed: CellRect,
    /// Changed cells and edge blocks that still wait; 0: every cost is exact.
    pub pending: u32,
}

/// Computes every cost from the cells.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_compute(map: *mut horus_cost_map) -> horus_status {
    // SAFETY: the pointer is the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = cost_map_mut(claims, map)?;
        map.compute_costs();
        Ok(())
    })
}

/// Brings every cost up to date with all changes since the last update: equal to
/// horus_cost_map_compute() in every byte. `changed`, which may be NULL, becomes the rectangle that
/// contains every cost that changed, all zero if none did; after a window shift the whole map.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_update(
    map: *mut horus_cost_map,
    changed: *mut CellRect,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = cost_map_mut(claims, map)?;
        let changed = claims.output_or_null(changed)?;
        changed.write(rect_or_empty(map.update_costs()));
        Ok(())
    })
}

/// Updates, but stops before it exceeds `budget` cell visits (one field or cost byte read or
/// written, or one bitmap word), and goes on with the next call. Sources that appeared come first:
/// once they are in, no known cell is cheaper than its final cost. `update` may be NULL.
///
/// Fails with HORUS_STATUS_BUDGET_TOO_SMALL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_update_within(
    map: *mut horus_cost_map,
    budget: u32,
    update: *mut horus_cost_update,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = cost_map_mut(claims, map)?;
        let to = claims.output_or_null(update)?;
        let update = map.update_costs_within(budget)?;
        to.write(horus_cost_update {
            changed: rect_or_empty(update.changed),
            pending: update.pending,
        });
        Ok(())
    })
}

/// The smallest budget, in cell visits; it depends on the parameters.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_min_budget(
    map: *const horus_cost_map,
    budget: *mut u32,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = cost_map(claims, map)?;
        let smallest = map.min_budget();
        claims.output(budget)?.write(smallest);
        Ok(())
    })
}

/// Upper bound on the calls of horus_cost_map_update_within() that make every cost exact if nothing
/// else changes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_calls_left(
    map: *const horus_cost_map,
    calls: *mut u32,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = cost_map(claims, map)?;
        let left = map.calls_left();
        claims.output(calls)?.write(left);
        Ok(())
    })
}

/// Changed cells and edge blocks that wait for an update; 0: every cost is exact.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_pending(
    map: *const horus_cost_map,
    pending: *mut u32,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = cost_map(claims, map)?;
        let waiting = map.pending();
        claims.output(pending)?.write(waiting);
        Ok(())
    })
}
