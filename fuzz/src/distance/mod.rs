//! Target `distance`: distances from the cells of a grid in every type, windows of them, rays through it; core against
//! the std version.

mod case;
mod maps;
mod rays;

pub use case::{DistanceCase, Query};

/// Runs a case; panics at the first disagreement.
pub fn run(case: &DistanceCase) {
    let Some(scene) = case.scene() else { return };
    for query in case.queries.0.iter().take(8) {
        match query {
            Query::Distances {
                cell,
                cap,
                unknown,
                window,
                rows,
            } => {
                maps::check_cell(*cell, &scene, *cap, *unknown, *window, u32::from(*rows));
            }
            Query::Rays { pose, bearing, range } => rays::check(&scene, pose, *bearing, *range),
            Query::Walk { from, to } => rays::check_walk(*from, *to),
        }
    }
}
