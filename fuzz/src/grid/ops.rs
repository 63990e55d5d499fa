use arbitrary::Arbitrary;

use crate::number::Number;
use crate::scene::{Fill, Model, Move, Place, Resolution, Scan};
use crate::sequence::Rest;

/// A grid and what is done to it.
#[derive(Clone, Debug, Arbitrary)]
pub struct GridCase {
    /// Done first, to have cells.
    pub start: GridOp,
    /// Done then.
    pub ops: Rest<GridOp>,
}

/// Columns and rows.
#[derive(Clone, Copy, Debug, Arbitrary)]
pub enum Size {
    /// Up to 63 cells on a side.
    Small(u8, u8),
    /// As many cells as they say, often too many.
    Any(u32, u32),
}

impl Size {
    /// Columns and rows.
    pub fn cells(self) -> (u32, u32) {
        match self {
            Self::Small(w, h) => (u32::from(w % 64), u32::from(h % 64)),
            Self::Any(w, h) => (w, h),
        }
    }
}

/// One operation on a grid.
#[derive(Clone, Debug, Arbitrary)]
pub enum GridOp {
    /// `reset` of core, a new grid of the std version.
    Reset {
        /// Columns and rows.
        size: Size,
        /// Metres per cell.
        resolution: Resolution,
        /// World pose of the corner.
        origin: Place,
    },
    /// `set_occupancy`.
    Set {
        /// Column.
        gx: u8,
        /// Row.
        gy: u8,
        /// Any value.
        value: i8,
    },
    /// `set_occupancy` with any indices.
    SetAnywhere {
        /// Column.
        gx: u32,
        /// Row.
        gy: u32,
    },
    /// `load`.
    Load(Fill),
    /// `integrate_scan`.
    Scan {
        /// The scan and the sensor's pose.
        scan: Scan,
        /// How it is drawn.
        model: Model,
        /// Core's workspace has too few cell bits.
        few_bits: bool,
    },
    /// `recenter`.
    Recenter(Move),
    /// Point queries at this many cells from the origin's position.
    Query(Number, Number),
}
