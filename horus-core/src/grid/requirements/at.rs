use nalgebra::Vector2;

use super::sealed::Sealed;
use super::{DenseGrid2, LinearGrid2};

/// What names a cell of a grid `G`: its coordinates, as `Vector2<i32>` or `(i32, i32)`, in any grid; its
/// row-major index, a `usize`, in a [`LinearGrid2`].
pub trait At<G: ?Sized>: Copy + Sealed {
    /// How neighbours of such a cell are named: `Vector2<i32>` for coordinates, `usize` for an index.
    type Name;

    /// The coordinates of the cell; `None` for an index outside the grid. Coordinates are not checked.
    fn cell(self, grid: &G) -> Option<Vector2<i32>>;

    /// The cell's value; outside: `None`.
    fn value(self, grid: &G) -> Option<G::Data>
    where
        G: DenseGrid2;

    /// The name of a cell that lies inside.
    fn name(grid: &G, cell: Vector2<i32>) -> Self::Name;
}

impl Sealed for Vector2<i32> {}
impl Sealed for (i32, i32) {}
impl Sealed for usize {}

impl<G: ?Sized> At<G> for Vector2<i32> {
    type Name = Self;

    #[inline]
    fn cell(self, _: &G) -> Option<Vector2<i32>> {
        Some(self)
    }

    #[inline]
    fn value(self, grid: &G) -> Option<G::Data>
    where
        G: DenseGrid2,
    {
        grid.value(self)
    }

    #[inline]
    fn name(_: &G, cell: Vector2<i32>) -> Self {
        cell
    }
}

impl<G: ?Sized> At<G> for (i32, i32) {
    type Name = Vector2<i32>;

    #[inline]
    fn cell(self, _: &G) -> Option<Vector2<i32>> {
        Some(Vector2::new(self.0, self.1))
    }

    #[inline]
    fn value(self, grid: &G) -> Option<G::Data>
    where
        G: DenseGrid2,
    {
        grid.value(Vector2::new(self.0, self.1))
    }

    #[inline]
    fn name(_: &G, cell: Vector2<i32>) -> Vector2<i32> {
        cell
    }
}

impl<G: LinearGrid2 + ?Sized> At<G> for usize {
    type Name = Self;

    #[inline]
    fn cell(self, grid: &G) -> Option<Vector2<i32>> {
        let width = grid.width() as usize;
        // The order: a grid without cells has no width to divide by.
        (self < grid.size()).then(|| Vector2::new((self % width) as i32, (self / width) as i32))
    }

    #[inline]
    fn value(self, grid: &G) -> Option<G::Data> {
        grid.data().get(self).copied()
    }

    #[inline]
    fn name(grid: &G, cell: Vector2<i32>) -> Self {
        cell.y as usize * grid.width() as usize + cell.x as usize
    }
}
