use arbitrary::Arbitrary;

use crate::number::Number;
use crate::scene::{BEAMS, Place, Resolution};
use crate::sequence::{Rest, Short};

/// A map and what happens to it.
#[derive(Clone, Debug, Arbitrary)]
pub struct LocalCase {
    /// Columns and rows, modulo 41.
    pub size: [u8; 2],
    /// Metres per cell.
    pub resolution: Resolution,
    /// Which footprint, modulo 3.
    pub footprint: u8,
    /// Radius of the footprint in cells.
    pub radius: Number,
    /// Lidars of others and of the map's own, modulo 3 and 2.
    pub lidars: [u8; 2],
    /// There is an odometry sensor of others, and of the map's own.
    pub odometry: [bool; 2],
    /// Done in this order.
    pub ops: Rest<LocalOp>,
}

/// One thing that happens.
#[derive(Clone, Debug, Arbitrary)]
pub enum LocalOp {
    /// A sensor writes into the state, as it should or not.
    Scan(Sensor),
    /// An odometry sensor writes: which one, and what.
    Odometry(bool, Place),
    /// Everything in the state is forgotten.
    ClearState,
    /// `update` with the robot's pose in the world, perhaps with too few workspaces.
    Update(Place, bool),
    /// `recenter`.
    Recenter(Place),
    /// `load` of a value for all cells.
    Load(u8),
    /// `publish`, and reading it.
    Publish,
    /// The cost map follows, and updates its costs.
    Follow,
}

/// What a lidar writes.
#[derive(Clone, Debug, Arbitrary)]
pub struct Sensor {
    /// Which one, modulo 3.
    pub which: u8,
    /// Where it sits; it says nothing about that where there is none.
    pub mount: Option<Place>,
    /// Tenths of a radian.
    pub start_angle: Number,
    /// Tenths of a radian.
    pub fov: Number,
    /// Cells.
    pub max_range: Number,
    /// Cells.
    pub ranges: Short<Number, { BEAMS as u8 }>,
    /// A buffer is left out, modulo 8.
    pub left_out: u8,
}
