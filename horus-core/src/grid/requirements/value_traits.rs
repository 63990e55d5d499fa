use crate::grid::{FREE, OCCUPIED, OCCUPIED_FROM, UNKNOWN};

/// What the values of an occupancy grid's cells mean. A value may be none of the three.
pub trait ValueTraits: Copy {
    /// What a cell holds.
    type Value: Copy;

    /// True if such a cell is free.
    fn is_free(&self, value: Self::Value) -> bool;

    /// True if such a cell is occupied.
    fn is_occupied(&self, value: Self::Value) -> bool;

    /// True if nothing is known about such a cell.
    fn is_unknown(&self, value: Self::Value) -> bool;
}

/// Values of an [`OccupancyGrid`](crate::grid::OccupancyGrid): free 0..50, occupied from 50 on, unknown -1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct HorusValues;

impl ValueTraits for HorusValues {
    type Value = i8;

    #[inline]
    fn is_free(&self, value: i8) -> bool {
        (FREE..OCCUPIED_FROM).contains(&value)
    }

    #[inline]
    fn is_occupied(&self, value: i8) -> bool {
        value >= OCCUPIED_FROM
    }

    #[inline]
    fn is_unknown(&self, value: i8) -> bool {
        value == UNKNOWN
    }
}

/// Values of a ROS map: free 0, occupied 100, unknown -1; every other value is none of these.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TrinaryValues;

impl ValueTraits for TrinaryValues {
    type Value = i8;

    #[inline]
    fn is_free(&self, value: i8) -> bool {
        value == FREE
    }

    #[inline]
    fn is_occupied(&self, value: i8) -> bool {
        value == OCCUPIED
    }

    #[inline]
    fn is_unknown(&self, value: i8) -> bool {
        value == UNKNOWN
    }
}

/// Values of a navground local map: free 255, occupied 0, unknown 128; every other value is none of these.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LocalMapValues;

impl LocalMapValues {
    /// Occupied.
    pub const OCCUPIED: u8 = 0;
    /// Unknown.
    pub const UNKNOWN: u8 = 128;
    /// Free.
    pub const FREE: u8 = 255;
}

impl ValueTraits for LocalMapValues {
    type Value = u8;

    #[inline]
    fn is_free(&self, value: u8) -> bool {
        value == Self::FREE
    }

    #[inline]
    fn is_occupied(&self, value: u8) -> bool {
        value == Self::OCCUPIED
    }

    #[inline]
    fn is_unknown(&self, value: u8) -> bool {
        value == Self::UNKNOWN
    }
}
