//! Rays through a grid. Where one starts and ends is decided in f32, in this order of operations.

use super::{BelugaGrid, Pose2D, standard_walk, supercover_walk, walk_cell, walk_steps};

/// Cells farther away than this are never addressed.
const CELL_LIMIT: u32 = 1 << 30;

/// Which cells between its two ends a ray visits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Walk {
    /// Beluga's standard walk.
    Standard,
    /// Beluga's supercover walk.
    Supercover,
    /// The walk of navground and nav2.
    Navground,
}

impl BelugaGrid<'_> {
    /// The cells of a ray from a global pose at a bearing relative to it, up to `range` metres, before the first one
    /// outside the map; none where the pose lies outside or something is not finite.
    pub fn trace(&self, pose: Pose2D, bearing: f64, range: f32, walk: Walk) -> Vec<[i32; 2]> {
        let Some((from, to)) = self.ray_ends(pose, bearing, range) else {
            return Vec::new();
        };
        let cells = match walk {
            Walk::Standard => standard_walk(from, to),
            Walk::Supercover => supercover_walk(from, to),
            Walk::Navground => {
                let steps = 0..=walk_steps(from, to);
                steps
                    .map(|step| walk_cell(from, to, step).map(|c| c as i32))
                    .collect()
            }
        };
        let inside = cells.into_iter().take_while(|cell| self.data_at(*cell).is_some());
        inside.collect()
    }

    /// Metres from the first cell of a ray to the first that is not free, centre to centre, at most the range; `None`
    /// if all are free.
    pub fn cast(&self, pose: Pose2D, bearing: f64, range: f32, walk: Walk) -> Option<f64> {
        let cells = self.trace(pose, bearing, range, walk);
        let hit = cells.iter().find(|cell| !self.free_at(**cell))?;
        let side = |axis: usize| f64::from(hit[axis]) - f64::from(cells[0][axis]);
        let metres = f64::from(self.grid.resolution) * side(0).hypot(side(1));
        Some(metres.min(range.into()))
    }

    fn ray_ends(&self, pose: Pose2D, bearing: f64, range: f32) -> Option<([i32; 2], [i32; 2])> {
        let frame = self.grid.frame();
        let corner = frame.corner();
        let (ct, st) = frame.heading();
        let [x, y, theta] = pose.to_f32()?;
        let (dx, dy) = (x - corner[0], y - corner[1]);
        let source = [ct * dx + st * dy, ct * dy - st * dx];
        // The heading in the local frame, then the bearing on top.
        let turned = |c: f32, s: f32, by: (f32, f32)| (c * by.0 - s * by.1, s * by.0 + c * by.1);
        let of = |angle: f32| (libm::cosf(angle), libm::sinf(angle));
        let (c, s) = turned(ct, -st, of(theta));
        let (c, s) = turned(c, s, of(bearing as f32));
        if range < 0.0 {
            return None;
        }
        let end = [source[0] + c * range, source[1] + s * range];
        let from = self.cell_of_f32(source)?;
        let to = self.cell_of_f32(end)?;
        let near = to.iter().all(|c| c.unsigned_abs() <= CELL_LIMIT);
        (near && self.data_at(from).is_some()).then_some((from, to))
    }

    /// [`cell_near`](Self::cell_near), decided in f32.
    fn cell_of_f32(&self, p: [f32; 2]) -> Option<[i32; 2]> {
        let cell = |x: f32| {
            let cell = x / self.grid.resolution + super::frame::BOUNDARY;
            let limit = 2_147_483_648.0_f32;
            (-limit <= cell && cell < limit).then(|| libm::floorf(cell) as i32)
        };
        Some([cell(p[0])?, cell(p[1])?])
    }
}
