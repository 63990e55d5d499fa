//! Cost maps: obstacles inflated by a falling cost, recomputed incrementally and exactly.
//!
//! A [`CostMap`] owns the grid it follows, so that no change can be missed. It keeps one squared
//! distance per cell (the field) and the sources that the field reflects; a cost is a table
//! look-up. [`update_costs`](CostMap::update_costs) leaves every byte equal to a fresh
//! [`compute_costs`](CostMap::compute_costs), at a cost proportional to what changed.

mod budget;
mod buffers;
mod changes;
#[cfg(any(test, all(feature = "dsp", target_arch = "arm")))]
mod dsp;
mod edges;
mod field;
mod footprint;
mod kernel;
mod layer;
mod map;
mod params;
mod refresh;
mod repair;
mod shift;
mod stale;
mod steps;
mod tables;
mod update;
mod words;
mod work;

#[cfg(test)]
mod tests;

pub use buffers::{CostBuffers, CostMapBuffers, bit_words};
pub use field::FieldCell;
pub use footprint::FootprintCost;
pub use kernel::scratch_words;
pub use map::{CostMap, CostUpdate};
pub use params::{CostParams, Decay};
pub use tables::CostTables;

/// The cost of a cell that nothing is known about.
pub const UNKNOWN_COST: u8 = 255;

/// A cell value as the byte that cost tables are indexed by.
pub(crate) trait CellValue: Copy {
    fn byte(self) -> u8;
}

impl CellValue for i8 {
    #[inline]
    fn byte(self) -> u8 {
        self as u8
    }
}

impl CellValue for u8 {
    #[inline]
    fn byte(self) -> u8 {
        self
    }
}
