//! Target `local`: drives of a local map, core and std version compared after every update, and a
//! cost map that follows.

mod ops;
mod pair;
mod storage;

pub use ops::{LocalCase, LocalOp, Sensor};
pub use pair::LocalPair;
pub use storage::LocalStorage;

/// Runs a case; panics at the first disagreement.
pub fn run(case: &LocalCase) {
    let mut storage = LocalStorage::new(case);
    let Some(mut pair) = LocalPair::new(case, &mut storage) else {
        return;
    };
    for op in case.ops.0.iter().take(60) {
        pair.apply(op);
    }
}
