//! What window shifts leave to be recomputed along the four edges of the map.

/// A strip along one edge, counted in cells from that edge.
///
/// Sources that left the window lay before column (or row) `lost`; cells up to `width` may have
/// had one of them as their nearest, and cells that came into view lie before `lost`, too.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Edge {
    pub lost: u32,
    pub width: u32,
}

impl Edge {
    /// The window moved `by` cells away from this edge's old place (negative: towards it, so that
    /// cells came into view), sources reach `radius` cells. A strip wider than the map does no harm.
    fn shift(&mut self, by: i32, radius: u32) {
        let along = |v: u32| v.saturating_add_signed(by.saturating_neg());
        if self.width > 0 {
            *self = Self {
                lost: along(self.lost),
                width: along(self.width),
            };
        }
        if by > 0 {
            self.width = self.width.max(self.lost + radius);
        } else if by < 0 {
            let exposed = by.unsigned_abs();
            self.lost = self.lost.max(exposed);
            self.width = self.width.max(exposed);
        }
    }
}

/// Which edge of the map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    Left,
    Right,
    Bottom,
    Top,
}

impl Side {
    pub(crate) const ALL: [Self; 4] = [Self::Left, Self::Right, Self::Bottom, Self::Top];
}

/// All four strips, and how many of their blocks have been recomputed.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Edges {
    edges: [Edge; 4],
    pub done: u32,
}

impl Edges {
    pub(crate) fn edge(&self, side: Side) -> Edge {
        self.edges.get(side as usize).copied().unwrap_or_default()
    }

    /// True if nothing waits.
    pub(crate) fn is_empty(&self) -> bool {
        self.edges.iter().all(|e| e.width == 0)
    }

    pub(crate) fn clear(&mut self) {
        *self = Self::default();
    }

    /// The window moved by `shift` cells. Everything is recomputed from its start.
    pub(crate) fn shift(&mut self, shift: [i32; 2], radius: u32) {
        self.done = 0;
        let [dx, dy] = shift;
        for (edge, by) in self
            .edges
            .iter_mut()
            .zip([dx, dx.saturating_neg(), dy, dy.saturating_neg()])
        {
            edge.shift(by, radius);
        }
    }
}
