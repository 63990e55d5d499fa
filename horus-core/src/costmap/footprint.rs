//! The cost under a robot's outline.

use super::UNKNOWN_COST;
use super::kernel::low_bits;
use crate::error::Error;
use crate::geometry::{GridInfo, Pose2D};
use crate::math;
use crate::walk::{End, GridWalk, Tie};

/// What lies under a polygon.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FootprintCost {
    /// The highest known cost; `None` if no cell under the polygon is known.
    pub cost: Option<u8>,
    /// A cell under the polygon is unknown.
    pub touches_unknown: bool,
    /// Part of the polygon lies outside the map.
    pub leaves_map: bool,
}

impl FootprintCost {
    fn add(&mut self, cost: Option<u8>) {
        match cost {
            Some(UNKNOWN_COST) => self.touches_unknown = true,
            Some(cost) => self.cost = Some(self.cost.map_or(cost, |highest| highest.max(cost))),
            None => {}
        }
    }
}

/// A vertex in continuous cell coordinates, and its cell.
#[derive(Clone, Copy)]
struct Vertex {
    x: f32,
    y: f32,
    cell: (i32, i32),
}

/// A polygon placed in a grid's window.
struct Placed<'a, V> {
    info: &'a GridInfo,
    pose: Pose2D,
    cos_sin: (f32, f32),
    polygon: &'a [V],
}

impl<V: Copy + Into<(f32, f32)>> Placed<'_, V> {
    fn vertex(&self, vertex: V) -> Option<Vertex> {
        let (vx, vy) = vertex.into();
        let (c, s) = self.cos_sin;
        let (wx, wy) = (self.pose.x + (c * vx - s * vy), self.pose.y + (s * vx + c * vy));
        let cell = self.info.world_to_cell(wx, wy)?;
        let (x, y) = self.info.world_to_continuous(wx, wy);
        Some(Vertex { x, y, cell })
    }

    /// Every edge, the closing one first.
    fn edges(&self) -> impl Iterator<Item = (Vertex, Vertex)> + '_ {
        let mut previous = self.polygon.last().and_then(|v| self.vertex(*v));
        self.polygon.iter().filter_map(move |v| {
            let next = self.vertex(*v);
            core::mem::replace(&mut previous, next).zip(next)
        })
    }
}

pub(crate) fn cost<V: Copy + Into<(f32, f32)>>(
    info: &GridInfo,
    pose: Pose2D,
    polygon: &[V],
    cost_at: impl Fn(u32, u32) -> Option<u8>,
) -> Result<FootprintCost, Error> {
    if !pose.is_finite() {
        return Err(Error::NonFinitePose);
    }
    let placed = Placed {
        info,
        pose,
        cos_sin: math::cos_sin(pose.theta),
        polygon,
    };
    if polygon.len() < 3 || polygon.iter().any(|v| placed.vertex(*v).is_none()) {
        return Err(Error::InvalidPolygon);
    }
    let mut under = FootprintCost::default();
    let (width, height) = (info.width(), info.height());
    // Bounding box of the vertices' cells: centres inside the polygon lie in it.
    let (mut low, mut high) = ((i32::MAX, i32::MAX), (i32::MIN, i32::MIN));
    for (from, to) in placed.edges() {
        let (x, y) = to.cell;
        low = (low.0.min(x), low.1.min(y));
        high = (high.0.max(x), high.1.max(y));
        under.leaves_map |= x as u32 >= width || y as u32 >= height;
        if let Some(walk) = GridWalk::new(from.cell, to.cell, Tie::Far, End::Included, (width, height)) {
            let per_row = width.max(1); // a walk has cells only where there are columns
            walk.for_each(|i| under.add(cost_at(i as u32 % per_row, i as u32 / per_row)));
        }
    }
    let columns = low.0.max(0) as u32..width.min((high.0 + 1).max(0) as u32);
    let rows = low.1.max(0) as u32..height.min((high.1 + 1).max(0) as u32);
    for gy in rows {
        for x0 in columns.clone().step_by(32) {
            let mut inside = parity(&placed, x0, gy) & low_bits(columns.end - x0);
            while inside != 0 {
                under.add(cost_at(x0 + inside.trailing_zeros(), gy));
                inside &= inside - 1;
            }
        }
    }
    Ok(under)
}

/// The cells x0..x0 + 32 of row `gy` whose centres are inside by the even-odd rule: an edge that
/// crosses the row's centre line at x flips the cells whose centre lies before x.
fn parity<V: Copy + Into<(f32, f32)>>(placed: &Placed<'_, V>, x0: u32, gy: u32) -> u32 {
    let cy = gy as f32 + 0.5;
    let mut inside = 0;
    for (a, b) in placed.edges() {
        if (a.y > cy) != (b.y > cy) {
            let x = (b.x - a.x) * (cy - a.y) / (b.y - a.y) + a.x;
            // gx + 0.5 < x for gx < ceil(x - 0.5): the subtraction is exact where it matters.
            let before = math::ceil(x - 0.5);
            inside ^= low_bits((before as u32).saturating_sub(x0));
        }
    }
    inside
}
