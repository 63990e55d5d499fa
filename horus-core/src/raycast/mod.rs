//! Rays through a grid: which cells one visits, and where it first meets something that is not free.
//!
//! Source: Beluga `raycasting.hpp` and `bresenham.hpp`; the tie rule of navground and nav2.

mod caster;

pub use caster::RayCaster;

pub use crate::walk::{CellWalk, WalkRule};
