use super::OccupancyGrid;

/// Added to a cell coordinate before rounding down, so that a point on a nominal boundary belongs to the upper cell
/// however the decimal numbers around it were rounded.
pub(super) const BOUNDARY: f32 = 1.0 / 1024.0;

/// Cells and window offsets beyond this on an axis are refused.
const CELL_LIMIT: u32 = 1 << 30;

/// A grid's f32 decision arithmetic: which cell a point is in, and how far a window shifts.
///
/// Another implementation has to reproduce every operation here, in this order.
pub(super) struct GridFrame {
    origin: [f32; 2],
    cos: f32,
    sin: f32,
    resolution: f32,
    offset: [i32; 2],
}

impl GridFrame {
    /// A grid whose first corner lies at `origin` (x, y in metres, heading in radians).
    pub(super) fn new(origin: [f32; 3], resolution: f32, offset: [i32; 2]) -> Self {
        let [x, y, theta] = origin;
        Self {
            origin: [x, y],
            cos: libm::cosf(theta),
            sin: libm::sinf(theta),
            resolution,
            offset,
        }
    }

    /// The centre of a cell of the window in the world.
    pub(super) fn center(&self, gx: u32, gy: u32) -> [f32; 2] {
        let local = |g: u32, axis: usize| (self.offset[axis] as f32 + g as f32 + 0.5) * self.resolution;
        let (x, y) = (local(gx, 0), local(gy, 1));
        [
            self.origin[0] + (self.cos * x - self.sin * y),
            self.origin[1] + (self.sin * x + self.cos * y),
        ]
    }

    /// World metres to metres along the axes of the grid as it was constructed.
    pub(super) fn local(&self, p: [f32; 2]) -> [f32; 2] {
        let (dx, dy) = (p[0] - self.origin[0], p[1] - self.origin[1]);
        [self.cos * dx + self.sin * dy, self.cos * dy - self.sin * dx]
    }

    /// (cos, sin) of the heading of the grid's axes.
    pub(super) fn heading(&self) -> (f32, f32) {
        (self.cos, self.sin)
    }

    /// World position of the corner of cell (0, 0) as it is now.
    pub(super) fn corner(&self) -> [f32; 2] {
        let [lx, ly] = self.offset.map(|cells| cells as f32 * self.resolution);
        [
            self.origin[0] + (self.cos * lx - self.sin * ly),
            self.origin[1] + (self.sin * lx + self.cos * ly),
        ]
    }

    /// The cell a world point lies in, inside the map or not; `None` if the point is not finite, here or along the
    /// grid's axes, or too far away to count.
    pub(super) fn cell(&self, p: [f32; 2]) -> Option<[i32; 2]> {
        let l = self.local(p);
        if !(l[0].is_finite() && l[1].is_finite()) {
            return None;
        }
        let cell = |axis: usize| {
            let k = libm::floorf(l[axis] / self.resolution + BOUNDARY) as i32;
            let cell = k.checked_sub(self.offset[axis])?;
            (cell.unsigned_abs() <= CELL_LIMIT).then_some(cell)
        };
        Some([cell(0)?, cell(1)?])
    }

    /// A world point in continuous cell coordinates of the map: cell (0, 0) spans 0..1 on both axes.
    pub(super) fn cell_coordinates(&self, p: [f32; 2]) -> [f32; 2] {
        let l = self.local(p);
        let coordinate = |axis: usize| l[axis] / self.resolution - self.offset[axis] as f32;
        [coordinate(0), coordinate(1)]
    }

    /// Whole cells to move so that a finite world point comes to lie in the middle, and the offset after that move;
    /// `None` if that offset is out of range.
    pub(super) fn shift(&self, p: [f32; 2], size: [u32; 2]) -> Option<([i32; 2], [i32; 2])> {
        let l = self.local(p);
        let axis = |axis: usize| {
            let centre = self.offset[axis] as f32 + size[axis] as f32 * 0.5;
            let shift = libm::rintf(l[axis] / self.resolution - centre);
            if shift.is_nan() || shift.abs() >= 2_147_483_648.0 {
                return None;
            }
            let shift = shift as i32;
            let offset = self.offset[axis].checked_add(shift)?;
            (offset.unsigned_abs() <= CELL_LIMIT).then_some((shift, offset))
        };
        let ((sx, ox), (sy, oy)) = (axis(0)?, axis(1)?);
        Some(([sx, sy], [ox, oy]))
    }
}

impl OccupancyGrid {
    pub(super) fn frame(&self) -> GridFrame {
        let origin = [self.origin0.x, self.origin0.y, self.origin0.theta].map(|v| v as f32);
        GridFrame::new(origin, self.resolution, self.offset)
    }
}
