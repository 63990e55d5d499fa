//! Programs whose text runs on the host and, in QEMU, on a Cortex-M4F.
//!
//! [`rt`] is what they stand on (start, print, send, exit), [`drive`] the scripted drive, [`report`] its
//! hashes, which must be the same everywhere, [`streaming`] how it becomes a stream of frames.
#![no_std]

pub mod drive;
pub mod hash;
pub mod report;
pub mod rt;
pub mod streaming;
