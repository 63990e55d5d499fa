//! Instructions and stack bytes of single calls, on the target.
//!
//! [`Meter`] counts, [`Stat`] sums up, [`Table`] prints a row per operation and tells whether its
//! target is reached. On the host it compiles and measures nothing.

mod clock;
mod cost;
mod measure;
mod stack;
mod stat;
mod table;

pub use cost::Cost;
pub use measure::Meter;
pub use stat::Stat;
pub use table::{Table, Target};
