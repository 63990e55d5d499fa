//! The embedded core against recorded outputs of HORUS, nav2, navground and Beluga, and of an oracle of exact fractions: the
//! tests of `golden_reference.rs`, with another subject. Every cost map is tested with one- and two-byte fields, with and without kept costs, computed in
//! full, by incremental updates and by updates with the smallest budget.

#[path = "golden/beluga.rs"]
mod beluga;
#[path = "golden/beluga_core.rs"]
mod beluga_subject;
#[path = "golden/evidence.rs"]
mod evidence;
#[path = "golden/evidence_core.rs"]
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
#[path = "golden/subject_core.rs"]
mod subject;
#[path = "golden/vectors.rs"]
mod vectors;
