//! Local mapping on both sides: the same scans into core's chain and the std version's, compared after each.
//!
//! Masses are quantities: core holds them in 16 bits, the std version in f64, nothing is ever brought into line, and
//! the largest difference is measured and held against a bound. The binary map must be equal but for cells within
//! that difference of a threshold, the distance map exactly that of core's binary map.

mod config;
mod distance;
mod engine;
mod layers;

pub use config::EvidenceConfig;
pub use engine::{EvidenceLockstep, EvidenceStorage, EvidenceTotals};
pub use layers::EvidenceLayers;
