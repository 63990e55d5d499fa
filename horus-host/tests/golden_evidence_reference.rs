//! The std version's evidence grids against golden vectors of an independent oracle.

#[path = "golden/evidence.rs"]
mod evidence;
#[path = "golden/evidence_subject_reference.rs"]
mod subject;
#[allow(dead_code, reason = "shared with the golden tests of grids and cost maps")]
#[path = "golden/vectors.rs"]
mod vectors;
