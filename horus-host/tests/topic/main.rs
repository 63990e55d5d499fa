//! Topics across real processes.
//!
//! The other process of a test is this program again, told by its environment to play a role.

mod both_versions;
mod faults;
mod flow;
mod grids;
mod mismatch;
mod peer;
