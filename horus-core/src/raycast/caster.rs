use nalgebra::{Isometry2, UnitComplex, Vector2};

use crate::geometry::CELL_LIMIT;
use crate::grid::{OccupancyGrid2d, ValueTraits};
use crate::math;
use crate::walk::{CellWalk, End, Far, GridWalk, Near, Tie, WalkRule};

/// Casts rays from one pose through a grid, up to a range.
///
/// A ray is the walk from the cell of the pose to the cell of the point `range` metres ahead at a
/// bearing, cut before the first cell outside the grid; it does not come back in. There is no ray, and nothing
/// is hit, where the pose lies outside the grid, pose, bearing or range is not finite, or the ray's end lies more
/// than 2^30 cells away.
///
/// Poses are in the grid's **global** frame, bearings are relative to the pose, counter-clockwise. No
/// trigonometry is computed here: an angle in radians becomes a bearing through `UnitComplex::new`.
///
/// Source: Beluga `Ray2d`.
///
/// # Examples
/// ```
/// use horus_core::nalgebra::{Isometry2, UnitComplex, Vector2};
/// use horus_core::prelude::*;
/// use horus_core::raycast::{RayCaster, WalkRule};
///
/// let mut cells = [0; 10 * 10];
/// let mut grid = OccupancyGrid::new_in(&mut cells[..], 10, 10, 0.5, Pose2D::new(0.0, 0.0, 0.0))?;
/// grid.load(&[0; 100])?;
/// grid.set_occupancy(8, 1, 100);
/// let pose = Isometry2::new(Vector2::new(1.25, 0.75), 0.0);
/// let rays = RayCaster::new(&grid, pose, 5.0, WalkRule::Standard);
/// assert_eq!(rays.cast(UnitComplex::identity()), Some(3.0));
/// assert_eq!(rays.cast(UnitComplex::new(1.0)), None, "the ray leaves the grid");
/// assert_eq!(rays.trace(UnitComplex::new(1.0)).last().map(|c| (c.x, c.y)), Some((7, 9)));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug)]
pub struct RayCaster<'a, G: ?Sized> {
    grid: &'a G,
    /// Where the rays start; `None` if there are none.
    source: Option<Source>,
    range: f32,
    rule: WalkRule,
}

#[derive(Clone, Copy, Debug)]
struct Source {
    /// In metres and in cells of the grid's local frame.
    point: Vector2<f32>,
    cell: Vector2<i32>,
    /// (cos, sin) of the heading in that frame.
    heading: (f32, f32),
}

impl<'a, G: OccupancyGrid2d + ?Sized> RayCaster<'a, G> {
    /// Rays of up to `range` metres from a pose in the grid's global frame.
    pub fn new(grid: &'a G, pose: Isometry2<f32>, range: f32, rule: WalkRule) -> Self {
        let point = grid.local_from_global(pose.translation.vector);
        let source = grid.cell_near(point).filter(|cell| grid.contains(*cell));
        let origin = grid.origin().rotation;
        Self {
            grid,
            source: source.map(|cell| Source {
                point,
                cell,
                heading: turned((origin.re, -origin.im), pose.rotation),
            }),
            range,
            rule,
        }
    }

    /// The cells of the ray at a bearing, the first that holds the pose, in order.
    ///
    /// # Complexity
    /// Constant time per cell; cells outside the grid are not visited.
    pub fn trace(&self, bearing: UnitComplex<f32>) -> impl Iterator<Item = Vector2<i32>> {
        let ends = self.ends(bearing);
        let walk = ends.map(|(from, to)| CellWalk::new(from, to, self.rule));
        walk.into_iter()
            .flatten()
            .take_while(|cell| self.grid.contains(*cell))
    }

    /// Metres to the first cell of the ray that is not free (occupied, unknown, or of no meaning), the one that
    /// holds the pose included: centre to centre, at most the range. `None` if all are free.
    ///
    /// # Complexity
    /// One cell visit per cell up to the one that is hit.
    pub fn cast(&self, bearing: UnitComplex<f32>) -> Option<f32> {
        let (from, to) = self.ends(bearing)?;
        let hit = match self.rule {
            WalkRule::Standard => self.first_not_free::<Near>(from, to),
            WalkRule::Navground => self.first_not_free::<Far>(from, to),
            WalkRule::Supercover => {
                let mut cells = CellWalk::new(from, to, self.rule).take_while(|c| self.grid.contains(*c));
                cells.find(|cell| !self.grid.free_at(*cell))
            }
        }?;
        // Both cells lie inside, where differences are below 2^30.
        let (dx, dy) = ((hit.x - from.x) as f32, (hit.y - from.y) as f32);
        let distance = self.grid.resolution() * math::sqrt(dx * dx + dy * dy);
        Some(distance.min(self.range))
    }

    fn first_not_free<T: Tie>(&self, from: Vector2<i32>, to: Vector2<i32>) -> Option<Vector2<i32>> {
        let size = (self.grid.width(), self.grid.height());
        let (values, data) = (self.grid.value_traits(), self.grid.data());
        // A walk never comes back into a rectangle: the part inside is the part before it leaves.
        let walk = GridWalk::new::<T>((from.x, from.y), (to.x, to.y), End::Included, size.0, size.1)?;
        let free = |i: usize| data.get(i).is_some_and(|value| values.is_free(*value));
        let hit = walk.find(|i| !free(i))? as u32;
        Some(Vector2::new(
            hit.checked_rem(size.0)? as i32,
            hit.checked_div(size.0)? as i32,
        ))
    }

    /// First and last cell of the uncut ray.
    fn ends(&self, bearing: UnitComplex<f32>) -> Option<(Vector2<i32>, Vector2<i32>)> {
        // A negative range is no ray.
        let source = self.source.filter(|_| self.range >= 0.0)?;
        let (cos, sin) = turned(source.heading, bearing);
        let end = source.point + Vector2::new(cos * self.range, sin * self.range);
        let cell = self.grid.cell_near(end)?;
        let near = |c: i32| (-CELL_LIMIT..=CELL_LIMIT).contains(&c);
        (near(cell.x) && near(cell.y)).then_some((source.cell, cell))
    }
}

/// A direction turned by an angle, in a fixed order of operations.
fn turned((cos, sin): (f32, f32), by: UnitComplex<f32>) -> (f32, f32) {
    (cos * by.re - sin * by.im, sin * by.re + cos * by.im)
}
