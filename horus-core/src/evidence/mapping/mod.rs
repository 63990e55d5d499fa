//! The chain of local mapping as one object.

mod buffers;
mod config;
mod local_mapping;
mod sensor;

pub use self::buffers::{LocalMappingBuffers, MappingBuffers};
pub use self::config::LocalMappingConfig;
pub use self::local_mapping::{LocalMapping, TickReport};
pub use self::sensor::{SensorConfig, SensorScan};
