//! What the fuzz targets share: inputs derived from bytes, and core and std version side by side.
//!
//! | module | what it is |
//! |---|---|
//! | [`number`] | floats that are mostly sensible and sometimes anything |
//! | [`sequence`] | sequences that are as long as the input allows, or short |
//! | [`scene`] | sizes, poses, scans, scan models |
//! | [`compare`] | what both sides must agree on |
//! | [`damage`] | what happens to stored and sent bytes |
//! | [`memory`] | how much memory something takes |
//! | [`grid`] | target `grid` |
//! | [`costmap`] | targets `costmap_u8` and `costmap_u16` |
//! | [`distance`] | target `distance` |
//! | [`local`] | target `local` |
//! | [`evidence`] | target `evidence` |
//! | [`mcap_reader`] | target `mcap_reader` |
//! | [`frames`] | target `frames` |

pub mod compare;
pub mod costmap;
pub mod damage;
pub mod distance;
pub mod evidence;
pub mod frames;
pub mod grid;
pub mod local;
pub mod mcap_reader;
pub mod memory;
pub mod number;
pub mod scene;
pub mod sequence;
