//! The library from C: grid, rolling window, scans, cost map, distances, rays and local map behind
//! `include/horus.h`.
//!
//! The functions carry C's names and do what their Rust namesakes do; their documentation is the
//! header's. All memory is the caller's: an object lies, with all its buffers behind it, in one
//! block that `horus_..._bytes` measures and `horus_..._init` fills.
//!
//! # Safety
//! What every function demands of its caller, as the header says it:
//! - A pointer is NULL or points to as many readable elements as its type and length say; one that
//!   is written through points to writable ones.
//! - A handle is NULL, came from an `init` whose memory has been left alone since, or points to at
//!   least four readable bytes that some program has initialised.
//! - One call at a time uses an object.
//!
//! Everything else is checked: NULL, alignment, lengths, overlap of what a call is given (an
//! object's whole block included), wrong and moved objects, enumerators, text. What fails a check
//! gets a status, and nothing has happened.
//!
//! # Adding to it
//! A new function opens with `Call::from_c`, takes every pointer through the claims it is given, and
//! forwards. A new kind of object implements `Object`: a tag, a configuration, and which buffers it
//! takes from the arena.
#![allow(unsafe_code, reason = "memory comes as pointers from C")]
#![allow(non_camel_case_types, reason = "these names are the header's")]
#![allow(clippy::missing_safety_doc, reason = "one contract for all, above")]
#![deny(clippy::undocumented_unsafe_blocks)]

mod arena;
mod call;
mod cost_map;
mod distance;
mod evidence;
mod geometry;
mod grid;
mod grid_reads;
mod local_map;
mod object;
#[cfg(all(feature = "panic-handler", target_os = "none"))]
mod panic;
mod scan;
mod sizes;
mod status;
mod text;
mod version;

#[cfg(test)]
mod tests;

pub use cost_map::*;
pub use distance::*;
pub use evidence::*;
pub use geometry::*;
pub use grid::*;
pub use grid_reads::*;
pub use local_map::*;
pub use scan::*;
pub use sizes::*;
pub use status::*;
pub use version::*;
