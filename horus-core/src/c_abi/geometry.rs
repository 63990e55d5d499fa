//! Plain values that cross the interface.

use super::call::Plain;
use crate::geometry::{CellRect, Pose2D};

/// A point in metres, in the frame that its user names.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct horus_point {
    /// Metres along the frame's x axis.
    pub x: f32,
    /// Metres along the frame's y axis.
    pub y: f32,
}

// SAFETY: two numbers.
unsafe impl Plain for horus_point {}

impl From<horus_point> for (f32, f32) {
    fn from(point: horus_point) -> Self {
        (point.x, point.y)
    }
}

/// A cell of a grid: column and row, from the corner at the origin.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct horus_cell {
    /// Column.
    pub gx: u32,
    /// Row; row 0 has the lowest y.
    pub gy: u32,
}

/// Whole cells along the grid's axes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct horus_shift {
    /// Columns.
    pub dx: i32,
    /// Rows.
    pub dy: i32,
}

impl From<[i32; 2]> for horus_shift {
    fn from([dx, dy]: [i32; 2]) -> Self {
        Self { dx, dy }
    }
}

// SAFETY: three numbers.
unsafe impl Plain for Pose2D {}
// SAFETY: four numbers.
unsafe impl Plain for CellRect {}

/// A rectangle for C, where an empty one stands for none.
pub(super) fn rect_or_empty(rect: Option<CellRect>) -> CellRect {
    rect.unwrap_or(CellRect {
        x0: 0,
        y0: 0,
        x1: 0,
        y1: 0,
    })
}
