use core::ops::Range;

use crate::geometry::GridInfo;

/// Where the map lies for one update: navground's arithmetic of points, cells and borders, f32 in
/// this order.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    pub size: [u32; 2],
    pub resolution: f32,
    /// Corner of cell (0, 0) in metres.
    low: [f32; 2],
    /// The far corner in metres.
    high: [f32; 2],
}

impl Frame {
    pub(super) fn new(info: &GridInfo) -> Self {
        let (resolution, size) = (info.resolution(), [info.width(), info.height()]);
        let [ox, oy] = info.offset();
        let low = [ox as f32 * resolution, oy as f32 * resolution];
        let high = [
            low[0] + size[0] as f32 * resolution,
            low[1] + size[1] as f32 * resolution,
        ];
        Self {
            size,
            resolution,
            low,
            high,
        }
    }

    /// Whole cells to move to have a point nearest to the centre, ties to even; as a float, which may
    /// be too large or not a number.
    pub(super) fn shift(&self, p: f32, axis: usize) -> f32 {
        let centre = self.low[axis] + self.size[axis] as f32 * self.resolution * 0.5;
        crate::math::rint((p - centre) / self.resolution)
    }

    /// The cell of a point; `None` outside the map and for what is not a number.
    #[inline]
    pub(super) fn cell(&self, x: f32, y: f32) -> Option<(i32, i32)> {
        Some((self.coordinate(x, 0)?, self.coordinate(y, 1)?))
    }

    #[inline]
    fn coordinate(&self, p: f32, axis: usize) -> Option<i32> {
        if p >= self.low[axis] {
            let k = ((p - self.low[axis]) / self.resolution) as u32; // truncates, saturates
            (k < self.size[axis]).then_some(k as i32) // sizes are at most 2^30
        } else {
            None
        }
    }

    /// The cell of a coordinate, moved to 0..=size where it lies outside; NaN gives 0.
    pub(super) fn clamped(&self, p: f32, axis: usize) -> u32 {
        (((p - self.low[axis]) / self.resolution) as u32).min(self.size[axis])
    }

    /// The end of a ray from `from` over `d`, in metres, cut at the map's borders: first along x, then
    /// along y.
    #[inline]
    pub(super) fn clip(&self, from: [f32; 2], d: [f32; 2]) -> [f32; 2] {
        let ([fx, fy], [dx, dy]) = (from, d);
        // No loop over the axes: where the compiler does not unroll it, its indices can panic.
        let (x, y) = self.cut(0, [fx, dx, fx + dx], [fy, dy, fy + dy]);
        let (y, x) = self.cut(1, [fy, dy, y], [fx, dx, x]);
        [x, y]
    }

    /// The end along an axis and along the other one, from start, length and end along each.
    #[inline(always)]
    fn cut(
        &self,
        axis: usize,
        [from, d, end]: [f32; 3],
        [other_from, other_d, other]: [f32; 3],
    ) -> (f32, f32) {
        let (low, high) = (self.low[axis], self.high[axis]);
        if end < low {
            let t = (low - from) / d;
            (low, other_from + other_d * t)
        } else if end > high {
            let t = (high - from) / d;
            (high - INSIDE_FAR_BORDER, other_from + other_d * t)
        } else {
            (end, other)
        }
    }

    /// Linear index of a cell inside the map.
    #[inline]
    pub(super) fn index(&self, (cx, cy): (i32, i32)) -> usize {
        cy as usize * self.size[0] as usize + cx as usize
    }

    /// Columns of a row; empty outside the map.
    pub(super) fn row_mut<'c>(&self, cells: &'c mut [u8], gy: u32, columns: Range<u32>) -> &'c mut [u8] {
        let start = gy as usize * self.size[0] as usize;
        let columns = start + columns.start as usize..start + columns.end as usize;
        cells.get_mut(columns).unwrap_or_default()
    }
}

/// A ray cut at the far border ends so many metres before it.
const INSIDE_FAR_BORDER: f32 = 0.001;
