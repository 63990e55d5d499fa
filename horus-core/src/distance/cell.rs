use core::fmt::Debug;

/// A cell of a [`DistanceMap`](super::DistanceMap): a squared distance in cells.
///
/// `u16` and `u32` hold the distance to the nearest obstacle, 0 for obstacles themselves. `i16` and `i32` are
/// **signed**: an obstacle holds minus the squared distance to the nearest cell that is none. Two bytes suffice
/// without a cap while `(width - 1)^2 + (height - 1)^2` stays below 65 535 (`i16`: 32 767), as in 181 x 181 cells
/// (128 x 128).
pub trait DistanceCell: Copy + Debug + Default + sealed::Cell {
    /// Obstacles hold the distance to what is no obstacle, negative.
    const SIGNED: bool;

    /// The largest cap, squared cells.
    const MAX_SQUARED: u32;

    /// The squared distance without its sign.
    fn squared(self) -> u32;

    /// True for an obstacle: 0, or negative where signed.
    fn is_obstacle(self) -> bool;
}

pub(super) mod sealed {
    /// Kept to the four integers. While columns are swept, a cell holds a plain distance.
    pub trait Cell {
        /// Stands for "no such cell in this column": beyond [`MAX_SIDE`](crate::distance::MAX_SIDE), or beyond
        /// the root of the largest cap.
        const NONE: u32;

        /// The cell of an obstacle, or of none, with a distance that the type holds.
        fn new(obstacle: bool, distance: u32) -> Self;

        /// The cell of an obstacle, or of none, next to another of its column.
        fn beside(obstacle: bool, other: Self) -> Self;

        /// That of two distances of one cell which is nearer.
        fn nearer(self, other: Self) -> Self;
    }
}

macro_rules! distance_cell {
    ($unsigned:ty, $signed:ty) => {
        impl DistanceCell for $unsigned {
            const SIGNED: bool = false;
            const MAX_SQUARED: u32 = Self::MAX as u32;

            #[inline(always)]
            fn squared(self) -> u32 {
                self.into()
            }

            #[inline(always)]
            fn is_obstacle(self) -> bool {
                self == 0
            }
        }

        impl sealed::Cell for $unsigned {
            const NONE: u32 = u16::MAX as u32;

            #[inline(always)]
            fn new(obstacle: bool, distance: u32) -> Self {
                if obstacle { 0 } else { distance as Self }
            }

            #[inline(always)]
            fn beside(obstacle: bool, other: Self) -> Self {
                let farther = other.saturating_add(1).min(Self::NONE as Self);
                if obstacle { 0 } else { farther }
            }

            #[inline(always)]
            fn nearer(self, other: Self) -> Self {
                self.min(other)
            }
        }

        impl DistanceCell for $signed {
            const SIGNED: bool = true;
            const MAX_SQUARED: u32 = Self::MAX as u32;

            #[inline(always)]
            fn squared(self) -> u32 {
                self.unsigned_abs().into()
            }

            #[inline(always)]
            fn is_obstacle(self) -> bool {
                self < 0
            }
        }

        impl sealed::Cell for $signed {
            const NONE: u32 = if Self::BITS == 16 {
                i16::MAX as u32
            } else {
                u16::MAX as u32
            };

            #[inline(always)]
            fn new(obstacle: bool, distance: u32) -> Self {
                let distance = distance as Self;
                if obstacle { -distance } else { distance }
            }

            #[inline(always)]
            fn beside(obstacle: bool, other: Self) -> Self {
                // Another of the other kind is the nearest such cell: one row away.
                let farther = |other: Self| other.max(0).saturating_add(1).min(Self::NONE as Self);
                if obstacle {
                    -farther(-other)
                } else {
                    farther(other)
                }
            }

            #[inline(always)]
            fn nearer(self, other: Self) -> Self {
                if self.is_obstacle() {
                    self.max(other)
                } else {
                    self.min(other)
                }
            }
        }
    };
}

distance_cell!(u16, i16);
distance_cell!(u32, i32);
