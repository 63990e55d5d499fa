use nalgebra::Vector2;

use super::{At, Neighborhood4, Point, RegularGrid};

/// A [`RegularGrid`] that is a finite rectangle with a value for every cell.
///
/// Cell (0, 0) has the lowest coordinates. Source: Beluga `DenseGrid2`.
pub trait DenseGrid2: RegularGrid {
    /// What a cell holds.
    type Data: Copy;

    /// Columns, at most 2^30.
    fn width(&self) -> u32;

    /// Rows, at most 2^30.
    fn height(&self) -> u32;

    /// The value of a cell; outside: `None`, never another cell's.
    fn value(&self, cell: Vector2<i32>) -> Option<Self::Data>;

    /// True if the cell lies inside.
    #[inline]
    fn contains(&self, at: impl At<Self>) -> bool {
        at.cell(self)
            .is_some_and(|cell| (cell.x as u32) < self.width() && (cell.y as u32) < self.height())
    }

    /// The value of a cell or an index; outside: `None`.
    #[inline]
    fn data_at(&self, at: impl At<Self>) -> Option<Self::Data> {
        at.value(self)
    }

    /// The value of the cell that holds a point (metres, local frame); outside or not finite: `None`.
    #[inline]
    fn data_near(&self, point: impl Point) -> Option<Self::Data> {
        self.value(self.cell_near(point)?)
    }

    /// The cells inside that share a side with a cell, in the order +x, +y, -x, -y, named as it was: coordinates
    /// for coordinates, indices for an index. None for a cell that lies outside itself.
    #[inline]
    fn neighborhood4<A: At<Self>>(&self, at: A) -> Neighborhood4<'_, Self, A> {
        Neighborhood4::new(self, at)
    }
}
