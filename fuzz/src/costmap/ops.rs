use arbitrary::Arbitrary;

use super::Params;
use crate::number::Number;
use crate::scene::{Fill, Model, Move, Place, Resolution, Scan, cells};
use crate::sequence::{Rest, Short};

/// A cost map and what is done to it.
#[derive(Clone, Debug, Arbitrary)]
pub struct CostCase {
    width: u8,
    height: u8,
    /// Metres per cell.
    pub resolution: Resolution,
    /// World pose of the corner.
    pub origin: Place,
    /// Parameters at first.
    pub params: Params,
    /// Cost bytes are kept.
    pub keep: bool,
    /// Scratch for radii up to 15 cells only.
    pub small_scratch: bool,
    /// What the buffers hold before.
    pub garbage: u8,
    /// Cells at first; unknown without.
    pub start: Option<Fill>,
    /// Done then.
    pub ops: Rest<CostOp>,
}

impl CostCase {
    /// Columns and rows.
    pub fn cells(&self, limit: u32) -> (u32, u32) {
        cells(self.width, self.height, limit)
    }
}

/// Cell visits of one call.
#[derive(Clone, Copy, Debug, Arbitrary)]
pub enum Budget {
    /// The smallest legal one.
    Least,
    /// That and some more.
    More(u16),
    /// That and much more.
    Much(u32),
}

impl Budget {
    /// The visits, where `least` is the smallest legal number.
    pub fn visits(self, least: u32) -> u32 {
        match self {
            Self::Least => least,
            Self::More(extra) => least.saturating_add(extra.into()),
            Self::Much(extra) => least.saturating_add(extra),
        }
    }
}

/// One operation on a cost map.
#[derive(Clone, Debug, Arbitrary)]
pub enum CostOp {
    /// `set_occupancy`.
    Set {
        /// Column, modulo one more than the width.
        gx: u8,
        /// Row, modulo one more than the height.
        gy: u8,
        /// Any value.
        value: i8,
    },
    /// `set_occupancy` of a rectangle of cells to 100, 0 or -1.
    Block {
        /// First column and row.
        from: [u8; 2],
        /// Columns and rows, modulo 8, plus 1.
        size: [u8; 2],
        /// Which value.
        value: BlockValue,
    },
    /// `integrate_scan`.
    Scan {
        /// The scan and the sensor's pose.
        scan: Scan,
        /// How it is drawn.
        model: Model,
    },
    /// `recenter`.
    Recenter(Move),
    /// `update_costs_within`, so many times.
    Within {
        /// Cell visits of each call.
        budget: Budget,
        /// Calls, modulo 4, plus 1.
        calls: u8,
    },
    /// `update_costs_within` with less than the smallest budget.
    TooLittle(u16),
    /// `update_costs_within` until nothing is pending.
    Drain(Budget),
    /// `update_costs`.
    Update,
    /// `compute_costs`.
    Compute,
    /// `set_params`.
    SetParams(Params),
    /// `load`.
    Load(Fill),
    /// `footprint_cost`.
    Footprint {
        /// Position in cells from the middle of the map, heading.
        place: Place,
        /// Vertices in cells from there.
        vertices: Short<(Number, Number), 8>,
    },
}

/// What a block of cells is set to.
#[derive(Clone, Copy, Debug, Arbitrary)]
pub enum BlockValue {
    /// 100.
    Occupied,
    /// 0.
    Free,
    /// -1.
    Unknown,
}

impl BlockValue {
    /// The occupancy value.
    pub fn occupancy(self) -> i8 {
        match self {
            Self::Occupied => 100,
            Self::Free => 0,
            Self::Unknown => -1,
        }
    }
}
