//! The local map: core against the std version on random drives, every byte; what must hold for
//! any drive; the cost map that follows; bad input.

mod bad_input;
mod cost_map;
mod drives;
mod pair;
mod properties;
mod state;
