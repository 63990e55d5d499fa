use nalgebra::{Isometry2, Vector2};

use super::{At, LinearGrid2, Point, ValueTraits};

/// A [`LinearGrid2`] whose values say whether a cell is free or occupied, and which has a place in the world.
///
/// Source: Beluga `OccupancyGrid2d`.
pub trait OccupancyGrid2d: LinearGrid2 {
    /// What the values mean.
    type Values: ValueTraits<Value = Self::Data>;

    /// What the values mean.
    fn value_traits(&self) -> Self::Values;

    /// The pose of the local frame in the global one: `global = origin * local`.
    fn origin(&self) -> Isometry2<f32>;

    /// True if the cell is free. Unknown, occupied and outside: false.
    #[inline]
    fn free_at(&self, at: impl At<Self>) -> bool {
        let values = self.value_traits();
        self.data_at(at).is_some_and(|value| values.is_free(value))
    }

    /// True if the point (metres, **local** frame) lies in a free cell. Unknown, occupied, outside and not finite:
    /// false.
    #[inline]
    fn free_near(&self, point: impl Point) -> bool {
        let values = self.value_traits();
        self.data_near(point).is_some_and(|value| values.is_free(value))
    }

    /// Indices of all free cells, ascending, lazily.
    ///
    /// # Complexity
    /// One cell visit per cell.
    #[inline]
    fn free_cells(&self) -> impl Iterator<Item = usize> {
        let values = self.value_traits();
        let cells = self.data().iter().enumerate();
        cells.filter_map(move |(i, value)| values.is_free(*value).then_some(i))
    }

    /// For every cell, in index order, whether it is occupied; lazily.
    ///
    /// # Complexity
    /// One cell visit per cell.
    #[inline]
    fn obstacle_data(&self) -> impl ExactSizeIterator<Item = bool> {
        let values = self.value_traits();
        self.data().iter().map(move |value| values.is_occupied(*value))
    }

    /// For every cell, in index order, whether it is unknown; lazily.
    ///
    /// # Complexity
    /// One cell visit per cell.
    #[inline]
    fn unknown_mask(&self) -> impl ExactSizeIterator<Item = bool> {
        let values = self.value_traits();
        self.data().iter().map(move |value| values.is_unknown(*value))
    }

    /// For every cell, in index order, whether it is occupied and shares a side with a free one; lazily.
    ///
    /// # Complexity
    /// One cell visit per cell, up to five for an occupied one.
    #[inline]
    fn obstacle_edge_mask(&self) -> impl ExactSizeIterator<Item = bool> {
        self.obstacle_data()
            .enumerate()
            .map(|(i, occupied)| occupied && self.neighborhood4(i).any(|neighbour| self.free_at(neighbour)))
    }

    /// A point of the local frame in the global one, metres.
    #[inline]
    fn global_from_local(&self, point: impl Point) -> Vector2<f32> {
        let (origin, p) = (self.origin(), point.vector());
        let (cos, sin) = (origin.rotation.re, origin.rotation.im);
        Vector2::new(
            origin.translation.x + (cos * p.x - sin * p.y),
            origin.translation.y + (sin * p.x + cos * p.y),
        )
    }

    /// A point of the global frame in the local one, metres.
    #[inline]
    fn local_from_global(&self, point: impl Point) -> Vector2<f32> {
        let origin = self.origin();
        let (cos, sin) = (origin.rotation.re, origin.rotation.im);
        let d = point.vector() - origin.translation.vector;
        Vector2::new(cos * d.x + sin * d.y, cos * d.y - sin * d.x)
    }
}
