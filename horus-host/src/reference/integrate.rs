use super::laser_scan::Beam;
use super::{
    LaserScan, OccupancyGrid, Pose2D, Rect, ReferenceError, ScanModel, ScanReport, walk_inside, walk_steps,
};

impl OccupancyGrid {
    /// Draws a scan into the map, seen from `sensor_pose` (metres and radians in the world).
    ///
    /// Every beam clears the cells of the integer walk from the sensor's cell up to, not including, the cell it hit; a
    /// beam that hit nothing clears its end cell at `range_max` too. Then all hits are marked, so no hit is erased by
    /// another beam of the same scan. A beam shorter than `range_min`, NaN or -inf is ignored. Which cells a beam
    /// takes does not depend on where the window lies, and the sensor may stand outside it; beams are ignored if their
    /// end, or the sensor, lies more than 2^30 cells from cell (0, 0).
    ///
    /// # Errors
    /// A pose or an angle that is not finite, a range limit that is NaN, or a model with illegal steps: the map has
    /// not changed then.
    pub fn integrate_scan(
        &mut self,
        scan: &LaserScan,
        sensor_pose: Pose2D,
        model: ScanModel,
    ) -> Result<ScanReport, ReferenceError> {
        scan.validate()?;
        model.validate()?;
        let frame = self.frame();
        let [x, y, yaw] = sensor_pose.to_f32().ok_or(ReferenceError::Pose("sensor pose"))?;
        let sensor = [x, y];
        let (c, s) = (libm::cosf(yaw), libm::sinf(yaw));
        let start = frame.cell(sensor);

        let mut report = ScanReport::default();
        let mut cleared = vec![false; self.data.len()];
        let mut hit = vec![false; self.data.len()];
        for (i, &range) in scan.ranges.iter().enumerate() {
            let (range, is_hit) = match scan.beam(range) {
                Beam::Hit(range) => (range, true),
                Beam::Miss(range) => (range, false),
                Beam::Ignored => {
                    report.ignored += 1;
                    continue;
                }
            };
            let [ux, uy] = scan.direction(i);
            let (dx, dy) = (c * ux - s * uy, s * ux + c * uy);
            let end = frame.cell([sensor[0] + dx * range, sensor[1] + dy * range]);
            let (Some(from), Some(to)) = (start, end) else {
                report.ignored += 1;
                continue;
            };
            for (step, [gx, gy]) in walk_inside(from, to, self.width, self.height) {
                if let Some(index) = self.index(gx, gy) {
                    let marks = is_hit && step == walk_steps(from, to);
                    let cells = if marks { &mut hit } else { &mut cleared };
                    cells[index] = true;
                }
            }
            report.hits += u32::from(is_hit);
            report.misses += u32::from(!is_hit);
        }

        let before = self.data.clone();
        for (index, value) in self.data.iter_mut().enumerate() {
            if hit[index] || cleared[index] {
                *value = model.apply(*value, hit[index]);
            }
        }
        report.changed = self.difference(&before);
        Ok(report)
    }

    /// Smallest rectangle of cells that differ from `before`, a copy of this grid's cells.
    fn difference(&self, before: &[i8]) -> Option<Rect> {
        let cells = (0..self.height).flat_map(|gy| (0..self.width).map(move |gx| (gx, gy)));
        Rect::around(cells.filter(|&(gx, gy)| self.index(gx, gy).is_some_and(|i| before[i] != self.data[i])))
    }
}
