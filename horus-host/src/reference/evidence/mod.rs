//! Evidence grids by their definitions: masses in f64, decisions (which beam covers which cell) in f32.

mod fuse;
mod lattice;
mod masses;
mod resample;
mod scan;

pub use fuse::{FusionOperator, conjunctive, fuse};
pub use lattice::Lattice;
pub use masses::Masses;
pub use resample::{resample, sample};
pub use scan::{Flatscan, ScanClass, SensorModel, classify, scan_to_evidence};
