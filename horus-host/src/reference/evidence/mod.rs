//! Evidence grids by their definitions: masses in f64, decisions (which beam covers which cell) in f32.

mod fuse;
mod lattice;
mod local_mapping;
mod masses;
mod post;
mod resample;
mod scan;

pub use fuse::{FusionOperator, conjunctive, fuse};
pub use lattice::Lattice;
pub use local_mapping::{LocalMapping, LocalMappingConfig, Sensor};
pub use masses::Masses;
pub use post::{BinaryThresholds, Inpaint, evidence_to_binary};
pub use resample::{resample, sample};
pub use scan::{Flatscan, ScanClass, SensorModel, classify, scan_to_evidence};
