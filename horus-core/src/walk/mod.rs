//! Integer cell walks: from one cell to another along a straight line.
//!
//! With `n` the larger and `m` the smaller of |dx|, |dy| (x dominant on a tie), every step moves one
//! cell along the dominant axis; after `i` steps the minor coordinate has moved `i * m / n` cells,
//! rounded to the nearest. The two rules differ where that is exactly between two cells: navground
//! and nav2 round away from the start, Beluga towards it. In integers both are
//! `(start + i * m) / n`, with `start` = `n / 2` and `(n - 1) / 2`.

mod cell_walk;
mod grid_walk;
mod rule;

pub use cell_walk::CellWalk;
pub(crate) use grid_walk::{End, GridWalk};
pub(crate) use rule::Tie;
pub use rule::WalkRule;

/// -1, 0 or 1: the direction of travel.
fn sign(from: i32, to: i32) -> i32 {
    i32::from(to > from) - i32::from(to < from)
}
