//! Target `grid`: operations on an occupancy grid, core and std version compared after each.

mod ops;
mod pair;

pub use ops::{GridCase, GridOp, Size};
pub use pair::GridPair;

/// Runs a case; panics at the first disagreement.
pub fn run(case: &GridCase) {
    let mut pair = GridPair::new();
    pair.apply(&case.start);
    for op in case.ops.0.iter().take(100) {
        pair.apply(op);
    }
}
