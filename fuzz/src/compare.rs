//! What core and the std version must agree on.

use std::fmt::{Debug, Display};

use horus_core::prelude::{CellRect, OccupancyGrid, ScanReport};
use horus_host::reference;

/// Both succeed or both refuse; the values where both succeed.
pub fn agreed<A: Debug, B: Debug, E: Display, D: Display>(
    what: &str,
    core: Result<A, E>,
    std: Result<B, D>,
) -> Option<(A, B)> {
    match (core, std) {
        (Ok(a), Ok(b)) => Some((a, b)),
        (Err(_), Err(_)) => None,
        (Ok(a), Err(e)) => panic!("{what}: core returned {a:?}, the std version refused: {e}"),
        (Err(e), Ok(b)) => panic!("{what}: core refused: {e}; the std version returned {b:?}"),
    }
}

/// Every cell, the offset and the sizes are equal.
pub fn same_grids<S: AsRef<[i8]>>(core: &OccupancyGrid<S>, std: &reference::OccupancyGrid) {
    assert_eq!((core.width(), core.height()), (std.width, std.height), "size");
    assert_eq!(core.info().offset(), std.offset(), "offset");
    same_cells("occupancy", core.data(), &std.data, std.width);
}

/// Panics naming the first cell that differs.
pub fn same_cells<T: Debug + PartialEq>(what: &str, core: &[T], std: &[T], width: u32) {
    assert_eq!(core.len(), std.len(), "{what}: number of cells");
    if let Some(i) = core.iter().zip(std).position(|(a, b)| a != b) {
        let (gx, gy) = (i % width as usize, i / width as usize);
        let count = core.iter().zip(std).filter(|(a, b)| a != b).count();
        panic!(
            "{what}: cell ({gx}, {gy}): core {:?}, expected {:?}; {count} cells differ",
            core[i], std[i]
        );
    }
}

/// Counts and rectangle are equal.
pub fn same_reports(core: ScanReport, std: reference::ScanReport) {
    let rect = core.changed.map(|r| (r.x0, r.y0, r.x1, r.y1));
    let std_rect = std.changed.map(|r| (r.x0, r.y0, r.x1, r.y1));
    assert_eq!(rect, std_rect, "scan report: changed");
    assert_eq!(
        (core.hits, core.misses, core.ignored),
        (std.hits, std.misses, std.ignored),
        "scan report: hits, misses, ignored"
    );
}

/// Smallest rectangle of the cells that differ.
pub fn difference(before: &[u8], after: &[u8], width: u32) -> Option<CellRect> {
    let cell = |i: usize| {
        let (gx, gy) = (i as u32 % width, i as u32 / width);
        CellRect {
            x0: gx,
            y0: gy,
            x1: gx + 1,
            y1: gy + 1,
        }
    };
    let differing = before.iter().zip(after).enumerate().filter(|(_, (a, b))| a != b);
    differing.map(|(i, _)| cell(i)).reduce(|a, b| a.union(&b))
}

/// Whether `inner` lies in `outer`.
pub fn is_within(inner: Option<CellRect>, outer: Option<CellRect>) -> bool {
    match (inner, outer) {
        (None, _) => true,
        (Some(inner), Some(outer)) => outer.union(&inner) == outer,
        (Some(_), None) => false,
    }
}
