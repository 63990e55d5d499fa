//! Local mapping with evidence grids.

mod config;
mod mapping;
mod reads;
mod tick;

pub use config::*;
pub(super) use mapping::Mapping;
pub use mapping::*;
pub use reads::*;
pub use tick::*;
