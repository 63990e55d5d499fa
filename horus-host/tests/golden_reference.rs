//! The std version against recorded outputs of HORUS, nav2, navground and Beluga, and of an oracle of exact fractions.
//!
//! The vectors are JSON (for navground with `.f32` beside it). A part of them is kept in `tests/golden` at the root of
//! the repository; where the full set lies beside the repository, the same tests run over that too. The name of each
//! test that starts with `horus_deviation` says where this library deliberately differs. `golden_core.rs` runs the
//! same tests, all but those of `reference_only`, over the embedded core.

#[path = "golden/beluga.rs"]
mod beluga;
#[path = "golden/beluga_reference.rs"]
mod beluga_subject;
#[path = "golden/evidence.rs"]
mod evidence;
#[path = "golden/evidence_reference.rs"]
mod evidence_subject;
#[path = "golden/horus_cells.rs"]
mod horus_cells;
#[path = "golden/horus_costs.rs"]
mod horus_costs;
#[path = "golden/horus_points.rs"]
mod horus_points;
#[path = "golden/local_map.rs"]
mod local_map;
#[path = "golden/maps.rs"]
mod maps;
#[path = "golden/nav2.rs"]
mod nav2;
#[path = "golden/navground.rs"]
mod navground;
#[path = "golden/reference_only.rs"]
mod reference_only;
#[path = "golden/subject_reference.rs"]
mod subject;
#[path = "golden/vectors.rs"]
mod vectors;
