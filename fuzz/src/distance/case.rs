use arbitrary::Arbitrary;
use horus_core::prelude::{CellRect, OccupancyGrid, Pose2D};
use horus_host::reference;

use crate::number::Number;
use crate::scene::{Fill, Place, Resolution, cells, std_pose};
use crate::sequence::Rest;

/// Most cells of a grid, so that the std version takes a millisecond. A line of them is longer than two-byte squares
/// reach.
const CELLS: u32 = 320;

/// A grid and what is asked of it.
#[derive(Clone, Debug, Arbitrary)]
pub struct DistanceCase {
    width: u8,
    height: u8,
    resolution: Resolution,
    origin: Place,
    fill: Fill,
    /// Asked one after the other.
    pub queries: Rest<Query>,
}

/// Something to ask.
#[derive(Clone, Debug, Arbitrary)]
pub enum Query {
    /// Distances of the whole map and of a window.
    Distances {
        /// Which type of cell.
        cell: u8,
        /// The cap in squared cells.
        cap: Option<u32>,
        /// Unknown cells are obstacles.
        unknown: bool,
        /// Two corners, mostly inside.
        window: [u16; 4],
        /// Rows per step.
        rows: u8,
    },
    /// Rays by every rule.
    Rays {
        /// Where from.
        pose: Place,
        /// Tenths of a radian.
        bearing: Number,
        /// Cells.
        range: Number,
    },
    /// A walk between two cells by every rule.
    Walk {
        /// Its first cell.
        from: [i16; 2],
        /// Its last cell, as seen from there.
        to: [i16; 2],
    },
}

/// The same grid for both sides.
pub struct Scene {
    /// Core's.
    pub core: OccupancyGrid<Vec<i8>>,
    /// The std version's.
    pub std: reference::OccupancyGrid,
}

impl DistanceCase {
    /// The grid; `None` if it is refused.
    pub(super) fn scene(&self) -> Option<Scene> {
        let (width, height) = cells(self.width, self.height, CELLS);
        let origin: Pose2D = self.origin.pose(self.resolution.0);
        let storage = vec![0; (width * height) as usize];
        let mut core = OccupancyGrid::new_in(storage, width, height, self.resolution.0, origin).ok()?;
        let mut std =
            reference::OccupancyGrid::try_new(width, height, self.resolution.0, std_pose(origin)).ok()?;
        core.load(&self.fill.values(std.data.len()))
            .expect("one value per cell");
        std.data.copy_from_slice(core.data());
        Some(Scene { core, std })
    }
}

/// The window between two corners; it may reach out of the grid by a cell.
pub(super) fn window(corners: [u16; 4], width: u32, height: u32) -> CellRect {
    let [a, b, c, d] = corners.map(u32::from);
    let (a, b, c, d) = (
        a % (width + 2),
        b % (width + 2),
        c % (height + 2),
        d % (height + 2),
    );
    CellRect {
        x0: a.min(b),
        x1: a.max(b),
        y0: c.min(d),
        y1: c.max(d),
    }
}
