//! Evidence grids: the cell types against exact fractions, and the chain of local mapping against the std version.

mod chain;
mod drift;
mod exact;
mod paint;
mod rules;
mod scene;
mod turns;
mod wall;
