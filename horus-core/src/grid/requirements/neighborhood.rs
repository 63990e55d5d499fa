use core::marker::PhantomData;

use nalgebra::Vector2;

use super::{At, DenseGrid2};

/// The cells inside a grid that share a side with one of its cells:
/// [`neighborhood4`](DenseGrid2::neighborhood4).
#[derive(Debug)]
pub struct Neighborhood4<'a, G: ?Sized, A> {
    grid: &'a G,
    /// `None` if the cell in the middle lies outside.
    middle: Option<Vector2<i32>>,
    next: usize,
    named: PhantomData<A>,
}

const SIDES: [(i32, i32); 4] = [(1, 0), (0, 1), (-1, 0), (0, -1)];

impl<'a, G: DenseGrid2 + ?Sized, A: At<G>> Neighborhood4<'a, G, A> {
    pub(super) fn new(grid: &'a G, at: A) -> Self {
        Self {
            grid,
            middle: at.cell(grid).filter(|cell| grid.contains(*cell)),
            next: 0,
            named: PhantomData,
        }
    }
}

impl<G: DenseGrid2 + ?Sized, A: At<G>> Iterator for Neighborhood4<'_, G, A> {
    type Item = A::Name;

    #[inline]
    fn next(&mut self) -> Option<A::Name> {
        let middle = self.middle?;
        while let Some(&(dx, dy)) = SIDES.get(self.next) {
            self.next += 1;
            // The middle lies inside, where coordinates are below 2^30.
            let cell = Vector2::new(middle.x.wrapping_add(dx), middle.y.wrapping_add(dy));
            if self.grid.contains(cell) {
                return Some(A::name(self.grid, cell));
            }
        }
        None
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (0, Some(SIDES.len().saturating_sub(self.next)))
    }
}
