//! Programs whose text runs on the host and, in QEMU, on a Cortex-M4F.
//!
//! [`rt`] is what they stand on (start, print, exit), [`drive`] the scripted drive whose hashes
//! must be the same everywhere, [`c_drive`] the one that C programs repeat.
#![no_std]

pub mod c_drive;
pub mod drive;
pub mod hash;
pub mod rt;
