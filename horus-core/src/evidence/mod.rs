//! Evidence grids: belief masses free, occupied and uncertain per cell (Dempster-Shafer theory), which
//! keep "nobody looked" apart from "the sensors disagree".

mod fusion;
mod grid;
mod lattice;
mod mapping;
mod mass;
mod post;
mod resample;
mod scan;
mod viewpoint;

pub use self::fusion::{FusionOperator, FusionReport, FusionRule, fuse};
use self::fusion::{Kernel, Tally};
pub use self::grid::EvidenceFusion;
pub use self::lattice::Lattice;
pub use self::mapping::{
    LocalMapping, LocalMappingBuffers, LocalMappingConfig, MappingBuffers, SensorConfig, SensorScan,
    TickReport,
};
pub use self::mass::{EvidenceF32, EvidenceU8, EvidenceU16, MassCell, Masses};
pub use self::post::{
    BinaryMap, BinaryThresholds, Inpaint, InpaintFrame, binary_to_distance, evidence_to_occupancy,
};
pub use self::resample::resample;
use self::scan::class_at;
pub use self::scan::{
    BeamLimits, Flatscan, ScanClass, SensorGrid, SensorModel, class_bytes, scan_to_evidence,
};
