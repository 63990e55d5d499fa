use nalgebra::Vector2;

use super::OccupancyGrid2d;
use super::sealed::Sealed;

/// The frame that coordinates of an [`OccupancyGrid2d`] are wanted in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Frame {
    /// The grid's own: metres along its axes from the corner of cell (0, 0).
    Local,
    /// The one the grid's origin is given in: `origin * local`.
    Global,
}

/// The only frame of a grid without an origin: [`Frame::Local`] for every
/// [`RegularGrid`](super::RegularGrid).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Local;

/// A frame that a grid `G` has: [`Local`] for all, [`Frame`] for those with an origin.
pub trait InFrame<G: ?Sized>: Copy + Sealed {
    /// A point of the grid's local frame in this one, metres.
    fn place(self, grid: &G, local: Vector2<f32>) -> Vector2<f32>;
}

impl Sealed for Local {}
impl Sealed for Frame {}

impl<G: ?Sized> InFrame<G> for Local {
    #[inline]
    fn place(self, _: &G, local: Vector2<f32>) -> Vector2<f32> {
        local
    }
}

impl<G: OccupancyGrid2d + ?Sized> InFrame<G> for Frame {
    #[inline]
    fn place(self, grid: &G, local: Vector2<f32>) -> Vector2<f32> {
        match self {
            Self::Local => local,
            Self::Global => grid.global_from_local(local),
        }
    }
}
