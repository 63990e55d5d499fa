#![no_std]
#![deny(unsafe_code)]
#![cfg_attr(not(any(feature = "c-abi", feature = "dsp")), forbid(unsafe_code))]
//! Occupancy grids and incremental cost maps for microcontrollers.
//!
//! Fixed capacity, no allocation, no panics, exact results, bounded work per tick. All storage is
//! the caller's; everything is f32 and integers, the same bits on host and target.
//!
//! # Layers
//! Each uses only what stands left of it:
//! `error`, `math` < `storage` < `geometry` < `walk` < [`grid`] < [`raycast`] < [`distance`] <
//! [`costmap`] < [`evidence`] < [`local`] < [`frames`] < `c_abi`
//! (the library from C; feature `c-abi`).
//!
//! # Frames and units
//! SI units, REP 103 axes, REP 105 frames, REP 117 ranges; angles in radians, counter-clockwise.
//! Grids are row-major with row 0 at the lowest y; the corner of cell (0, 0) lies at the origin.

// On a host, a static library takes its panic handler from std.
#[cfg(all(feature = "c-abi", not(target_os = "none")))]
extern crate std;

#[cfg(feature = "c-abi")]
pub mod c_abi;
pub mod costmap;
pub mod distance;
pub mod error;
pub mod evidence;
pub mod frames;
pub mod geometry;
pub mod grid;
pub mod local;
mod math;
pub mod prelude;
pub mod raycast;
pub mod storage;
mod walk;

/// The README's examples.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;

pub use error::Error;
pub use nalgebra;
