use nalgebra::Vector2;

use super::{At, InFrame, Point};
use crate::geometry::cell_along;

/// A plane divided into square cells of one size; it has no end.
///
/// Source: Beluga `RegularGrid`.
pub trait RegularGrid {
    /// Side of a cell in metres, finite and above zero; 0 for a grid without cells.
    fn resolution(&self) -> f32;

    /// The cell that holds a point (metres, local frame), also outside of what the grid stores; `None` for a point
    /// that is not finite or whose cell is beyond the range of `i32`.
    ///
    /// A point on a nominal cell boundary belongs to the upper cell.
    #[inline]
    fn cell_near(&self, point: impl Point) -> Option<Vector2<i32>> {
        let (p, resolution) = (point.vector(), self.resolution());
        Some(Vector2::new(
            cell_along(p.x, resolution)?,
            cell_along(p.y, resolution)?,
        ))
    }

    /// Coordinates (metres) of a cell's centre in a frame. Cells may lie outside of what the grid stores; an index
    /// that does: `None`.
    #[inline]
    fn coordinates_at(&self, at: impl At<Self>, frame: impl InFrame<Self>) -> Option<Vector2<f32>> {
        let (cell, resolution) = (at.cell(self)?, self.resolution());
        let centre = cell.map(|c| (c as f32 + 0.5) * resolution);
        Some(frame.place(self, centre))
    }

    /// Coordinates (metres) of the centres of a range of cells or indices, lazily and in the same order. Indices
    /// outside the grid have none and are left out.
    fn coordinates_for<R>(&self, range: R, frame: impl InFrame<Self>) -> impl Iterator<Item = Vector2<f32>>
    where
        R: IntoIterator,
        R::Item: At<Self>,
    {
        range
            .into_iter()
            .filter_map(move |at| self.coordinates_at(at, frame))
    }
}
