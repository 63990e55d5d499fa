//! The embedded core's evidence grids against golden vectors: the tests of `golden_evidence_reference.rs`, with another
//! subject, in every cell type.

#[path = "golden/evidence.rs"]
mod evidence;
#[path = "golden/evidence_subject_core.rs"]
mod subject;
#[allow(dead_code, reason = "shared with the golden tests of grids and cost maps")]
#[path = "golden/vectors.rs"]
mod vectors;
