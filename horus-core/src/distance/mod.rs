//! Exact distance from every cell to the nearest obstacle.
//!
//! Distances are squared, whole numbers of cells, so they are exact; metres are a view. Time is linear in
//! the number of cells: two sweeps find each cell's nearest obstacle in its own column, then every row is the lower
//! envelope of the parabolas that its columns raise.
//!
//! The incremental cost map has its own field: it needs distances up to a small radius only, and needs them
//! repaired rather than computed anew, which bitmaps do several times faster than an envelope; the two share no kernel.
//!
//! Source: the envelope is that of Meijster, Roerdink and Hesselink, *A general algorithm for computing distance
//! transforms in linear time* (2000), and of Felzenszwalb and Huttenlocher, *Distance transforms of sampled functions*
//! (2012). Beluga's `nearest_obstacle_distance_map` asks for the same and approximates it.

mod buffers;
mod cell;
mod columns;
mod envelope;
mod lanes;
mod map;
mod options;
mod rows;
#[cfg(test)]
mod tests;

pub use buffers::{DistanceBuffers, DistanceMapBuffers};
pub use cell::DistanceCell;
pub use envelope::EnvelopeVertex;
pub use map::DistanceMap;
pub(crate) use map::Regions;
pub use options::{DistanceOptions, UnknownAs};

/// Most columns and rows of a grid that distances are computed of: squares of two sides fit 31 bits.
pub const MAX_SIDE: u32 = 32_767;
