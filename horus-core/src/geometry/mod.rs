//! Poses, cell rectangles, and the arithmetic that decides which cell a point lies in.

mod info;
mod pose;
mod rect;

pub use info::GridInfo;
pub(crate) use info::cell_along;
pub use pose::Pose2D;
pub(crate) use rect::Bounds;
pub use rect::CellRect;

/// Cells farther than this from the window's corner are never addressed: 2^30.
pub const CELL_LIMIT: i32 = 1 << 30;
