//! Programs whose text runs on the host and, in QEMU, on a Cortex-M4F.
//!
//! [`rt`] is what they stand on (start, print, send, exit), [`drive`] the scripted drive, [`report`] its
//! hashes, which must be the same everywhere, [`streaming`] how it becomes a stream of frames, [`c_drive`],
//! [`c_distance`], [`c_local`] and [`c_evidence`] what C programs repeat, [`evidence`] a drive of local mapping,
//! [`meter`] and [`workload`] what is measured and on what.
#![no_std]

mod arena;
pub mod c_distance;
pub mod c_drive;
pub mod c_evidence;
pub mod c_local;
pub mod drive;
pub mod evidence;
pub mod hash;
mod made_up;
pub mod meter;
mod once;
pub mod report;
pub mod rt;
pub mod streaming;
pub mod workload;

pub use arena::{Arena, ZeroBits};
pub use once::Once;
