use super::grid::UNKNOWN;
use super::{OccupancyGrid, Pose2D, ReferenceError};

impl OccupancyGrid {
    /// Moves the window by whole cells, along its own axes, so that `pose` (metres in the world) comes to lie in its
    /// middle; returns the cells moved in x and y.
    ///
    /// Cells keep their place in the world. Cells that come into the window are unknown; after a jump of more than
    /// the window's size all of them are. The window never rotates.
    ///
    /// # Errors
    /// A pose that is not finite, or a window more than 2^30 cells from its first origin: nothing has changed then.
    pub fn recenter(&mut self, pose: Pose2D) -> Result<(i32, i32), ReferenceError> {
        let [x, y, _] = pose.to_f32().ok_or(ReferenceError::Pose("pose to recenter on"))?;
        let ([sx, sy], offset) = self
            .frame()
            .shift([x, y], [self.width, self.height])
            .ok_or(ReferenceError::WindowOffset)?;
        if [sx, sy] == [0, 0] {
            return Ok((0, 0));
        }
        let mut moved = Vec::with_capacity(self.data.len());
        for gy in 0..i64::from(self.height) {
            for gx in 0..i64::from(self.width) {
                moved.push(self.value_or_unknown(gx + i64::from(sx), gy + i64::from(sy)));
            }
        }
        self.data = moved;
        self.offset = offset;
        let (x, y) = self.corner_plus(0.0, 0.0);
        self.origin = Pose2D::new(x, y, self.origin0.theta);
        Ok((sx, sy))
    }

    fn value_or_unknown(&self, gx: i64, gy: i64) -> i8 {
        match (u32::try_from(gx), u32::try_from(gy)) {
            (Ok(gx), Ok(gy)) => self.occupancy(gx, gy).unwrap_or(UNKNOWN),
            _ => UNKNOWN,
        }
    }
}
