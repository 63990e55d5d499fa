//! Straight edges.

/// A straight edge from `a` to `b`, in metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// First end: x, y.
    pub a: (f64, f64),
    /// Second end: x, y.
    pub b: (f64, f64),
}

impl Segment {
    /// The distance along the ray from (`x`, `y`) in the unit direction (`dx`, `dy`) at which it
    /// meets the edge, both ends included; `None` if it does not or runs parallel.
    pub fn ray(&self, (x, y): (f64, f64), (dx, dy): (f64, f64)) -> Option<f64> {
        let (ex, ey) = (self.b.0 - self.a.0, self.b.1 - self.a.1);
        let (wx, wy) = (self.a.0 - x, self.a.1 - y);
        let cross = dx * ey - dy * ex;
        let along_edge = (wx * dy - wy * dx) / cross;
        // A parallel ray divides by zero: infinite or NaN lies in no range.
        if !(0.0..=1.0).contains(&along_edge) {
            return None;
        }
        let distance = (wx * ey - wy * ex) / cross;
        (distance >= 0.0).then_some(distance)
    }

    /// The distance from a point to the nearest point of the edge.
    pub fn distance(&self, (x, y): (f64, f64)) -> f64 {
        let (ex, ey) = (self.b.0 - self.a.0, self.b.1 - self.a.1);
        let (px, py) = (x - self.a.0, y - self.a.1);
        let squared = ex * ex + ey * ey;
        let along = if squared > 0.0 {
            ((px * ex + py * ey) / squared).clamp(0.0, 1.0)
        } else {
            0.0
        };
        libm::hypot(px - along * ex, py - along * ey)
    }
}
