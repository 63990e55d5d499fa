/// Where a local map lies: its arithmetic of points and cells, f32 in this order.
pub(super) struct LocalFrame {
    pub resolution: f32,
    pub size: [u32; 2],
    pub offset: [i32; 2],
}

impl LocalFrame {
    pub fn low(&self, axis: usize) -> f32 {
        self.offset[axis] as f32 * self.resolution
    }

    pub fn high(&self, axis: usize) -> f32 {
        self.low(axis) + self.size[axis] as f32 * self.resolution
    }

    /// The cell of a point, `None` outside.
    pub fn cell(&self, p: [f32; 2]) -> Option<[u32; 2]> {
        let coordinate = |axis: usize| {
            if p[axis].is_nan() || p[axis] < self.low(axis) {
                return None;
            }
            let k = libm::truncf((p[axis] - self.low(axis)) / self.resolution);
            (k < self.size[axis] as f32).then_some(k as u32)
        };
        Some([coordinate(0)?, coordinate(1)?])
    }

    /// The cell of a coordinate, or 0 or the size where it lies outside.
    pub fn clamped_coordinate(&self, p: f32, axis: usize) -> i64 {
        let k = libm::truncf((p - self.low(axis)) / self.resolution) as i64;
        k.clamp(0, i64::from(self.size[axis]))
    }

    /// Whole cells to move on an axis to have `p` nearest to the middle.
    pub fn shift(&self, p: f32, axis: usize) -> f32 {
        let centre = self.low(axis) + self.size[axis] as f32 * self.resolution * 0.5;
        libm::rintf((p - centre) / self.resolution)
    }
}
