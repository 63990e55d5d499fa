//! What an algorithm may ask of a grid: Beluga's named requirements as traits.
//!
//! ```text
//! RegularGrid       cells of one size                     requires resolution
//!   < DenseGrid2    a finite rectangle, a value per cell  requires width, height, value
//!   < LinearGrid2   the values lie in a row-major slice   requires data
//!   < OccupancyGrid2d  values say free or occupied; the   requires origin, value_traits
//!                      grid has a place in the world
//! ```
//! Everything else is a default method, so a new kind of grid writes six short methods and an algorithm
//! asks for the least it needs. Implemented by [`OccupancyGrid`](super::OccupancyGrid) over every storage
//! and by the borrowed [`GridView`].
//!
//! **Names.** `_at` takes an exact cell, `_near` a point, `_for` a range. A cell is a
//! `Vector2<i32>` or an `(i32, i32)`, an index a `usize`: one method takes all of them ([`At`]); a point is a
//! `Vector2<f32>`, a `Point2<f32>` or an `(f32, f32)` ([`Point`]).
//!
//! **Frames.** Points are metres in the grid's *local* frame, whose origin is the corner of cell (0, 0);
//! `global = origin * local`. The namesakes that [`OccupancyGrid`](super::OccupancyGrid) has of its own
//! (`world_to_grid`, `is_free`) take world points.
//!
//! Source: Beluga named requirements (Ekumen), with two differences: a cell or an index outside the grid
//! has no value and is not free (Beluga reads another row), and a point on a nominal cell boundary belongs to
//! the upper cell (Beluga follows the noise of its decimals).
//!
//! # Examples
//! ```
//! use horus_core::grid::{Frame, GridView, TrinaryValues};
//! use horus_core::grid::{DenseGrid2, LinearGrid2, OccupancyGrid2d, RegularGrid};
//! use horus_core::prelude::*;
//!
//! /// Works on any grid: the free cell nearest to its corner, in world coordinates.
//! fn first_free(grid: &impl OccupancyGrid2d) -> Option<(f32, f32)> {
//!     let mut free = grid.coordinates_for(grid.free_cells(), Frame::Global);
//!     free.next().map(|p| (p.x, p.y))
//! }
//!
//! static PRIOR: [i8; 6] = [100, 100, 100, 100, 0, -1]; // a map in flash
//! let map = GridView::new(&PRIOR, 3, 2, 0.5, Pose2D::new(10.0, 0.0, 0.0), TrinaryValues)?;
//! assert_eq!(first_free(&map), Some((10.75, 0.75)));
//! assert!(map.free_at(4) && map.free_at((1, 1)) && map.free_near((0.7, 0.6)));
//! assert!(!map.free_at((3, 0)), "outside, not the first cell of the next row");
//! assert_eq!(map.neighborhood4(0).collect::<Vec<usize>>(), [1, 3]);
//! # Ok::<(), Error>(())
//! ```

mod at;
mod dense_grid;
mod frame;
mod linear_grid;
mod neighborhood;
mod occupancy_grid;
mod of_occupancy;
mod point;
mod regular_grid;
mod value_traits;
mod view;

pub use at::At;
pub use dense_grid::DenseGrid2;
pub use frame::{Frame, InFrame, Local};
pub use linear_grid::LinearGrid2;
pub use neighborhood::Neighborhood4;
pub use occupancy_grid::OccupancyGrid2d;
pub use point::Point;
pub use regular_grid::RegularGrid;
pub use value_traits::{HorusValues, LocalMapValues, TrinaryValues, ValueTraits};
pub use view::GridView;

/// Keeps the argument traits to the types of this module.
mod sealed {
    pub trait Sealed {}
}
