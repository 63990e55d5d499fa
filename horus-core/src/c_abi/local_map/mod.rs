//! The local map, with its sensing state and the directions of its lidars' beams.

mod map;
mod reads;
mod update;
mod writes;

pub(super) use map::LocalMap;
pub use map::*;
pub use reads::*;
pub use update::*;
pub use writes::*;
