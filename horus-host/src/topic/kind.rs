//! What a message is. A new kind of message is one line in `kinds!` below.

use std::fmt::Debug;

use iceoryx2::prelude::ZeroCopySend;

use super::{GridHeader, LocalGridHeader, ScanHeader, TransformEntry, TransformHeader};

/// Numbers of a fixed layout, for which all bits zero are a value.
///
/// # Safety
/// Every bit pattern is a value, there is no padding, and nothing points anywhere.
pub unsafe trait Plain: ZeroCopySend + Copy + Debug + PartialEq + 'static {}

// SAFETY: numbers.
unsafe impl Plain for i8 {}
// SAFETY: numbers.
unsafe impl Plain for u8 {}
// SAFETY: numbers.
unsafe impl Plain for f32 {}
// SAFETY: arrays of what is plain have no padding.
unsafe impl<T: Plain, const N: usize> Plain for [T; N] {}

/// A kind of message: a header, and as many elements as the header says.
pub trait Kind: Debug + Copy + Eq + 'static {
    /// What precedes the elements.
    type Header: Plain + Default + Counted;
    /// A cell, a beam.
    type Element: Plain;
    /// HORUS's name for a topic of such messages: the type's name in snake case.
    const TOPIC: &'static str;
}

/// A header that knows how many elements follow it.
pub trait Counted {
    /// The number; saturates where it cannot be.
    fn count(&self) -> usize;
}

macro_rules! kinds {
    ($($(#[$doc:meta])* $name:ident: $header:ty, [$element:ty], $topic:literal;)*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub struct $name;

        impl Kind for $name {
            type Header = $header;
            type Element = $element;
            const TOPIC: &'static str = $topic;
        }
    )*};
}

kinds! {
    /// Occupancy: -1 unknown, 0 free to 100 occupied.
    Occupancy: GridHeader, [i8], "occupancy_grid";
    /// Costs: 0 free to 253 or 254 lethal, 255 unknown.
    Costs: GridHeader, [u8], "cost_map";
    /// A navground local grid map: 0 occupied, 128 unknown, 255 free.
    Local: LocalGridHeader, [u8], "local_grid_map";
    /// Evidence: the masses of free and occupied; what is missing to 1 is unknown.
    Evidence: GridHeader, [[f32; 2]], "evidence_grid";
    /// Metres to the nearest obstacle.
    Distance: GridHeader, [f32], "distance_map";
    /// Ranges in metres, REP 117.
    Scan: ScanHeader, [f32], "laser_scan";
    /// Where frames stand in their parents.
    Transforms: TransformHeader, [TransformEntry], "transforms";
}
