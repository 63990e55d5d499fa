//! From scans to evidence: which beam covers a cell, and what it says about it.

mod beams;
mod bearing;
mod class;
mod classes;
mod flatscan;
mod model;
mod project;
mod sensor_grid;

pub use self::beams::BeamLimits;
pub use self::class::ScanClass;
pub(super) use self::classes::class_at;
pub use self::classes::class_bytes;
pub use self::flatscan::Flatscan;
pub use self::model::SensorModel;
pub use self::project::scan_to_evidence;
pub use self::sensor_grid::SensorGrid;
