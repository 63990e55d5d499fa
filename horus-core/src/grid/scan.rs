use crate::error::Error;
use crate::geometry::CellRect;

/// One revolution of a planar lidar, borrowed: `sensor_msgs/LaserScan`'s fields.
///
/// Beam `i` points to `angle_min + i * angle_increment` radians, counter-clockwise from the
/// sensor's x axis; ranges and limits are metres and follow REP 117.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LaserScan<'a> {
    /// Angle of the first beam in radians.
    pub angle_min: f32,
    /// Angle between beams in radians; may be negative.
    pub angle_increment: f32,
    /// Ranges below this are too close to be measured: ignored.
    pub range_min: f32,
    /// Ranges from this on are misses.
    pub range_max: f32,
    /// One range per beam.
    pub ranges: &'a [f32],
}

impl LaserScan<'_> {
    pub(crate) fn validate(&self) -> Result<(), Error> {
        let valid = self.angle_min.is_finite()
            && self.angle_increment.is_finite()
            && !self.range_min.is_nan()
            && !self.range_max.is_nan();
        if valid { Ok(()) } else { Err(Error::InvalidScan) }
    }

    /// What a range says, REP 117.
    #[inline]
    pub(crate) fn beam(&self, range: f32) -> Beam {
        // The limits are numbers, so a NaN range fails every comparison.
        if range >= self.range_min && range < self.range_max && range.is_finite() {
            Beam::Hit
        } else if range >= self.range_min && range > f32::NEG_INFINITY {
            Beam::Miss
        } else {
            Beam::Ignored
        }
    }
}

/// What one beam of a scan says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Beam {
    Hit,
    Miss,
    Ignored,
}

/// How a scan changes the cells it sees.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ScanModel {
    /// Cleared cells become 0, hit cells 100.
    #[default]
    Set,
    /// Every hit cell takes one step of `hit`, every other cleared cell one step of `miss`; at
    /// most one step per cell and scan, each clamped to `min..=max`; an unknown cell starts at 50.
    Accumulate {
        /// Added to a hit cell, >= 0.
        hit: i8,
        /// Added to a cleared cell, <= 0.
        miss: i8,
        /// Lowest value that a step leaves, >= 0.
        min: i8,
        /// Highest value that a step leaves, <= 100.
        max: i8,
    },
}

impl ScanModel {
    /// [`Accumulate`](Self::Accumulate) with +20 per hit and -7 per miss between 0 and 100.
    pub const fn accumulate() -> Self {
        Self::Accumulate {
            hit: 20,
            miss: -7,
            min: 0,
            max: 100,
        }
    }

    pub(crate) fn validate(&self) -> Result<(), Error> {
        match *self {
            Self::Accumulate { hit, miss, min, max }
                if hit < 0 || miss > 0 || min < 0 || max > 100 || min > max =>
            {
                Err(Error::InvalidModel)
            }
            _ => Ok(()),
        }
    }
}

/// What a scan did to a grid.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ScanReport {
    /// Smallest rectangle of the cells whose value differs from before the scan; `None` if none.
    pub changed: Option<CellRect>,
    /// Beams that ended at an obstacle, inside the map or not.
    pub hits: u32,
    /// Beams that saw nothing up to `range_max`.
    pub misses: u32,
    /// Beams without a usable range, or that end more than 2^30 cells away.
    pub ignored: u32,
}
