//! Targets `costmap_u8` and `costmap_u16`: operations on a cost map; occupancy compared after each,
//! every cost after each finished update, and what is promised while an update is pending.

mod ops;
mod pair;
mod params;
mod promises;
mod storage;
mod updates;

pub use ops::{Budget, CostCase, CostOp};
pub use pair::CostPair;
pub use params::{Params, StdParams};
pub use storage::{Storage, Width};

use crate::compare::agreed;
use crate::scene::std_pose;
use horus_host::reference;

/// Runs a case with field cells of type `F`; panics at the first disagreement.
pub fn run<F: Width>(case: &CostCase) {
    let (width, height) = case.cells(F::CELLS);
    let resolution = case.resolution.0;
    let origin = case.origin.pose(resolution);
    let std = reference::OccupancyGrid::try_new(width, height, resolution, std_pose(origin));
    let mut storage = Storage::<F>::new((width, height), case.keep, case.small_scratch, case.garbage);
    let (grid, buffers) = storage.split();
    let core = horus_core::prelude::OccupancyGrid::new_in(grid, width, height, resolution, origin);
    let Some((grid, std)) = agreed("new_in", core, std) else {
        return;
    };
    let Some(mut pair) = CostPair::new(grid, buffers, std, case) else {
        return;
    };
    for op in case.ops.0.iter().take(50) {
        pair.apply(op);
    }
    pair.apply(&CostOp::Drain(Budget::Least));
}
