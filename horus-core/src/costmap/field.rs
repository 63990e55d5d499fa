//! The distance field's cells and the inflated costs they stand for.

use core::fmt::Debug;

use super::kernel::PREFER_LANES;
use super::kernel::stamp::{COLUMNS, LANES};
use super::words;

/// Largest squared distance that the near kernel tables hold: offsets up to 15 cells.
pub(crate) const NEAR_LIMIT: u32 = 255;
/// Largest squared distance that the middle kernel tables hold: offsets up to 31 cells.
pub(crate) const MIDDLE_LIMIT: u32 = 1023;

mod sealed {
    pub trait Sealed {}
    impl Sealed for u8 {}
    impl Sealed for u16 {}
}

/// A cell of the distance field: the squared distance, in cells, to the nearest source.
///
/// `u8` serves effective radii up to 15 cells, `u16` up to 255: no sum of two squares within
/// those radii reaches the two largest values, which mean "no source in reach" and "stale".
pub trait FieldCell: Copy + Debug + Eq + Ord + sealed::Sealed + 'static {
    /// Inflated costs by field value; all-zero at first.
    #[doc(hidden)]
    type Costs: InflatedCosts + 'static;
    /// Rows of a disc, for radii up to 15 cells where they are of use.
    #[doc(hidden)]
    type Windows: AsRef<[[Self; COLUMNS]]> + AsMut<[[Self; COLUMNS]]> + Copy + Debug + 'static;
    #[doc(hidden)]
    const NO_WINDOWS: Self::Windows;
    /// Largest offset, in cells, with a cost above zero.
    const MAX_RADIUS: u32;
    /// A source.
    #[doc(hidden)]
    const ZERO: Self;
    /// No source in reach.
    #[doc(hidden)]
    const NONE: Self;
    /// Must be recomputed before anyone reads it.
    #[doc(hidden)]
    const STALE: Self;
    /// Saturates to [`NONE`](Self::NONE).
    #[doc(hidden)]
    fn new(squared: u32) -> Self;
    #[doc(hidden)]
    fn squared(self) -> u32;
    /// From a one-byte field.
    #[doc(hidden)]
    fn from_near(value: u8) -> Self;
    #[doc(hidden)]
    fn saturating_add(self, other: Self) -> Self;
    #[doc(hidden)]
    fn wrapping_add(self, other: Self) -> Self;
    /// Squares of `from`, `from + 1`, ... cells, saturated; `|from|` is at most
    /// [`MAX_RADIUS`](Self::MAX_RADIUS) + 64.
    #[doc(hidden)]
    fn squares_from(from: i32) -> &'static [Self];

    /// True if discs that reach this far, 11 cells at most, can be stamped in fewer steps.
    #[doc(hidden)]
    fn is_narrow(_reach: u32) -> bool {
        false
    }

    /// What [`lower`](Self::lower) and [`mark_stale`](Self::mark_stale) take for a column that is
    /// to stay as it is, in a disc that reaches this far.
    #[doc(hidden)]
    fn beyond(_reach: u32) -> Self {
        Self::NONE
    }

    /// Lowers each cell to its column's square; `N` is 24 if the disc
    /// [`is_narrow`](Self::is_narrow), else 32.
    #[doc(hidden)]
    #[inline(always)]
    fn lower<const N: usize>(row: &mut [Self; N], squares: &[Self; N]) {
        lower_each(row, squares);
    }

    /// Marks each cell stale that equals its column's square.
    #[doc(hidden)]
    #[inline(always)]
    fn mark_stale(row: &mut [Self; LANES], squares: &[Self; LANES]) {
        mark_each(row, squares);
    }

    /// The stale cells of up to 32, a bit each.
    #[doc(hidden)]
    #[inline]
    fn stale_bits(row: &[Self]) -> u32 {
        let bit = |(lane, cell): (usize, &Self)| u32::from(*cell == Self::STALE) << lane;
        row.iter().enumerate().map(bit).fold(0, |bits, bit| bits | bit)
    }
}

#[inline(always)]
fn lower_each<F: FieldCell>(row: &mut [F], squares: &[F]) {
    for (cell, square) in row.iter_mut().zip(squares) {
        *cell = (*cell).min(*square);
    }
}

#[inline(always)]
fn mark_each<F: FieldCell>(row: &mut [F], squares: &[F]) {
    for (cell, square) in row.iter_mut().zip(squares) {
        let is_stale = (*cell == *square) & (*square != F::NONE);
        *cell = if is_stale { F::STALE } else { *cell };
    }
}

impl FieldCell for u8 {
    type Costs = NearCosts;
    type Windows = [[Self; COLUMNS]; 16];
    const NO_WINDOWS: Self::Windows = [[0; COLUMNS]; 16];
    const MAX_RADIUS: u32 = 15;
    const ZERO: Self = 0;
    const NONE: Self = 255;
    const STALE: Self = 254;

    #[inline]
    fn new(squared: u32) -> Self {
        squared.min(255) as u8
    }

    #[inline]
    fn squared(self) -> u32 {
        self.into()
    }

    #[inline]
    fn from_near(value: u8) -> Self {
        value
    }

    #[inline]
    fn saturating_add(self, other: Self) -> Self {
        u8::saturating_add(self, other)
    }

    #[inline]
    fn wrapping_add(self, other: Self) -> Self {
        u8::wrapping_add(self, other)
    }

    #[inline]
    fn squares_from(from: i32) -> &'static [Self] {
        const CENTRE: usize = 15 + 64;
        static TABLE: [u8; 2 * CENTRE + 1] = {
            let mut squares = [255; 2 * CENTRE + 1];
            let mut d = 0;
            while d < 16 {
                squares[CENTRE + d] = (d * d) as u8;
                squares[CENTRE - d] = (d * d) as u8;
                d += 1;
            }
            squares
        };
        TABLE.get((CENTRE as i32 + from) as usize..).unwrap_or_default()
    }

    fn is_narrow(reach: u32) -> bool {
        !PREFER_LANES && reach < words::NO_SQUARE.into()
    }

    fn beyond(reach: u32) -> Self {
        if Self::is_narrow(reach) {
            words::NO_SQUARE
        } else {
            Self::NONE
        }
    }

    #[inline(always)]
    fn lower<const N: usize>(row: &mut [Self; N], squares: &[Self; N]) {
        if PREFER_LANES {
            lower_each(row, squares);
        } else {
            words::lower(row, squares);
        }
    }

    #[inline(always)]
    fn mark_stale(row: &mut [Self; LANES], squares: &[Self; LANES]) {
        if PREFER_LANES {
            mark_each(row, squares);
        } else {
            words::mark(row, squares, Self::STALE);
        }
    }

    #[inline]
    fn stale_bits(row: &[Self]) -> u32 {
        words::equal_bits(row, Self::STALE)
    }
}

impl FieldCell for u16 {
    type Costs = FarCosts;
    type Windows = [[Self; COLUMNS]; if PREFER_LANES { 16 } else { 0 }];
    const NO_WINDOWS: Self::Windows = [[0; COLUMNS]; if PREFER_LANES { 16 } else { 0 }];
    const MAX_RADIUS: u32 = 255;
    const ZERO: Self = 0;
    const NONE: Self = 65535;
    const STALE: Self = 65534;

    #[inline]
    fn new(squared: u32) -> Self {
        squared.min(65535) as u16
    }

    #[inline]
    fn squared(self) -> u32 {
        self.into()
    }

    #[inline]
    fn from_near(value: u8) -> Self {
        if value == u8::NONE {
            Self::NONE
        } else {
            value.into()
        }
    }

    #[inline]
    fn saturating_add(self, other: Self) -> Self {
        u16::saturating_add(self, other)
    }

    #[inline]
    fn wrapping_add(self, other: Self) -> Self {
        u16::wrapping_add(self, other)
    }

    #[inline]
    fn squares_from(from: i32) -> &'static [Self] {
        const CENTRE: usize = 255 + 64;
        static TABLE: [u16; 2 * CENTRE + 1] = {
            let mut squares = [65535; 2 * CENTRE + 1];
            let mut d = 0;
            while d < 256 {
                squares[CENTRE + d] = (d * d) as u16;
                squares[CENTRE - d] = (d * d) as u16;
                d += 1;
            }
            squares
        };
        TABLE.get((CENTRE as i32 + from) as usize..).unwrap_or_default()
    }
}

/// Looks up the inflated cost of a squared distance.
#[doc(hidden)]
pub trait InflatedCosts: Copy + Debug {
    const EMPTY: Self;
    /// Takes costs for 0, 1, 2, ... up to `reach`, none increasing; zero beyond.
    fn fill(&mut self, reach: u32, cost: impl Fn(u32) -> u8);
    fn cost(&self, squared: u32) -> u8;
}

/// One cost per field value.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct NearCosts([u8; 256]);

impl InflatedCosts for NearCosts {
    const EMPTY: Self = Self([0; 256]);

    fn fill(&mut self, reach: u32, cost: impl Fn(u32) -> u8) {
        fill_direct(&mut self.0, reach, cost);
    }

    #[inline]
    fn cost(&self, squared: u32) -> u8 {
        self.0.get(squared as usize).copied().unwrap_or(0)
    }
}

/// One cost per squared distance up to 31 cells; beyond, the farthest squared distance of each
/// cost, searched in eight steps. The same 1 KiB serves both.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct FarCosts {
    bytes: [u8; MIDDLE_LIMIT as usize + 1],
    reach: u32,
}

impl FarCosts {
    /// Squared distances from which on a cost is below `level`, for levels 1..=255.
    fn end_of(&self, level: u32) -> u32 {
        let i = 2 * level as usize;
        match (self.bytes.get(i), self.bytes.get(i + 1)) {
            (Some(&low), Some(&high)) => u32::from(u16::from_le_bytes([low, high])),
            _ => 0,
        }
    }
}

impl InflatedCosts for FarCosts {
    const EMPTY: Self = Self {
        bytes: [0; MIDDLE_LIMIT as usize + 1],
        reach: 0,
    };

    fn fill(&mut self, reach: u32, cost: impl Fn(u32) -> u8) {
        self.reach = reach;
        if reach <= MIDDLE_LIMIT {
            fill_direct(&mut self.bytes, reach, cost);
            return;
        }
        self.bytes.fill(0);
        let mut level = 255;
        for squared in 0..=reach {
            let cost = u32::from(cost(squared));
            while level > cost {
                let end = (squared as u16).to_le_bytes();
                let i = 2 * level as usize;
                for (to, from) in self.bytes.iter_mut().skip(i).zip(end) {
                    *to = from;
                }
                level -= 1;
            }
        }
        for level in 1..=level {
            let end = ((reach + 1) as u16).to_le_bytes();
            for (to, from) in self.bytes.iter_mut().skip(2 * level as usize).zip(end) {
                *to = from;
            }
        }
    }

    fn cost(&self, squared: u32) -> u8 {
        if squared > self.reach {
            return 0;
        }
        if self.reach <= MIDDLE_LIMIT {
            return self.bytes.get(squared as usize).copied().unwrap_or(0);
        }
        // The highest level that has not ended yet.
        let (mut low, mut high) = (0u32, 255u32);
        while low < high {
            let middle = (low + high).div_ceil(2);
            if squared < self.end_of(middle) {
                low = middle
            } else {
                high = middle - 1
            }
        }
        low as u8
    }
}

fn fill_direct(costs: &mut [u8], reach: u32, cost: impl Fn(u32) -> u8) {
    for (squared, to) in costs.iter_mut().enumerate() {
        *to = if squared as u32 <= reach {
            cost(squared as u32)
        } else {
            0
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thresholds_equal_the_table_they_stand_for() {
        for reach in [0u32, 5, 1023, 1024, 30_000, 65_025, 65_533] {
            for slope in [1u32, 7, 300] {
                let cost = |s: u32| (254u32.saturating_sub(s / slope)).max(1) as u8;
                let mut costs = FarCosts::EMPTY;
                costs.fill(reach, cost);
                for squared in 0..=reach {
                    assert_eq!(costs.cost(squared), cost(squared), "{squared} of {reach}");
                }
                assert_eq!(costs.cost(reach + 1), 0);
                assert_eq!(costs.cost(u32::MAX), 0);
            }
        }
    }

    #[test]
    fn reserved_values_are_no_distances() {
        let sums = |limit: u32| (0..=limit).flat_map(move |a| (0..=a).map(move |b| a * a + b * b));
        assert!(sums(15).filter(|s| *s < 256).all(|s| s < 254));
        assert!(sums(255).filter(|s| *s < 65536).all(|s| s < 65534));
    }
}
