//! Walls as boxes.

use super::OrientedBox;
use super::floor_plan::{Along, HALF_WALL, WallSpan};

impl WallSpan {
    /// The solid parts: the whole stretch, or what its door or window leaves of it. They reach
    /// half a wall's thickness into the crossing walls, so that corners are closed.
    pub(super) fn boxes(&self) -> Vec<OrientedBox> {
        let (start, end) = (self.span.0 - HALF_WALL, self.span.1 + HALF_WALL);
        let pieces = match self.opening {
            None => vec![(start, end)],
            Some((centre, width)) => {
                vec![(start, centre - 0.5 * width), (centre + 0.5 * width, end)]
            }
        };
        let (low, high) = (self.at - HALF_WALL, self.at + HALF_WALL);
        let solid = |(from, to): (f64, f64)| match self.along {
            Along::X => OrientedBox::upright((from, low), (to, high)),
            Along::Y => OrientedBox::upright((low, from), (high, to)),
        };
        pieces.into_iter().map(solid).collect()
    }
}
