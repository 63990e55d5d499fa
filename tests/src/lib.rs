//! Programs whose text runs on the host and, in QEMU, on a Cortex-M4F.
//!
//! [`rt`] is what they stand on (start, print, exit), [`drive`] the scripted drive whose hashes
//! must be the same everywhere, [`meter`] and [`workload`] what is measured and on what.
#![no_std]

mod arena;
pub mod drive;
pub mod hash;
pub mod meter;
mod once;
pub mod rt;
pub mod workload;

pub use arena::{Arena, ZeroBits};
pub use once::Once;
