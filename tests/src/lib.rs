//! Programs whose text runs on the host and, in QEMU, on a Cortex-M4F.
//!
//! [`rt`] is what they stand on (start, print, send, exit), [`drive`] the scripted drive, [`report`] its
//! hashes, which must be the same everywhere, [`streaming`] how it becomes a stream of frames, [`c_drive`] a
//! drive that C programs repeat.
#![no_std]

pub mod c_drive;
pub mod drive;
pub mod hash;
pub mod report;
pub mod rt;
pub mod streaming;
