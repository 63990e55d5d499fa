//! Core against the std version on random sequences of operations, every byte.
//!
//! A failing case is shrunk by proptest and printed with the grid as a picture.

mod conformance;
mod cost_map;
mod distance;
mod footprint;
mod op;
mod pair;
mod rays;
mod scans;
