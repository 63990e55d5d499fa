//! Exact distances, and rays.

mod map;
mod operations;
mod rays;
mod reads;

pub(super) use map::AnyDistanceMap;
pub use map::*;
pub use rays::*;
pub use reads::*;
