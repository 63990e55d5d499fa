use thiserror::Error;

use crate::reference::ReferenceError;

/// Why a lockstep run cannot start.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum LockstepError {
    /// A map without cells, or with more than [`LockstepConfig::MOST_CELLS`](super::LockstepConfig::MOST_CELLS).
    #[error("a map of {width} x {height} cells is not possible: it needs 1 to {most} cells")]
    Size {
        /// Columns asked for.
        width: u32,
        /// Rows asked for.
        height: u32,
        /// The largest number of cells.
        most: u64,
    },
    /// A side longer than distances can be computed along.
    #[error("a map of {width} x {height} cells is not possible: distances need at most {most} on a side")]
    Side {
        /// Columns asked for.
        width: u32,
        /// Rows asked for.
        height: u32,
        /// The longest side.
        most: u32,
    },
    /// Costs above zero reach farther than a two-byte field holds.
    #[error(
        "an inflation radius of {radius} m at {resolution} m per cell reaches beyond {max_cells} cells, \
         the most a two-byte field holds"
    )]
    Radius {
        /// Metres asked for.
        radius: f32,
        /// Metres per cell.
        resolution: f32,
        /// Largest effective radius in cells.
        max_cells: u32,
    },
    /// Memory for the map could not be allocated.
    #[error("there is not enough memory for a map of {width} x {height} cells")]
    Memory {
        /// Columns asked for.
        width: u32,
        /// Rows asked for.
        height: u32,
    },
    /// The core refused the geometry or a parameter.
    #[error(transparent)]
    Core(#[from] horus_core::Error),
    /// The std version refused what the core accepted.
    #[error(transparent)]
    Std(#[from] ReferenceError),
}
