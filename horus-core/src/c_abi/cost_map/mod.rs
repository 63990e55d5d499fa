//! The cost map.

mod map;
mod operations;
mod params;
mod reads;
mod update;
mod writes;

pub(super) use map::AnyCostMap;
pub use map::*;
pub use params::*;
pub use reads::*;
pub use update::*;
pub use writes::*;
