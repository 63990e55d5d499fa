//! Rectangular obstacles.

use super::Segment;

/// A rectangle at any angle: a piece of wall, a cabinet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrientedBox {
    /// Centre along x, in metres.
    pub x: f64,
    /// Centre along y, in metres.
    pub y: f64,
    /// Unit vector (x, y) of its first side.
    pub axis: (f64, f64),
    /// Half the length of the first side, in metres.
    pub half_length: f64,
    /// Half the length of the other side, in metres.
    pub half_width: f64,
}

impl OrientedBox {
    /// The box between two opposite corners with sides along x and y.
    pub fn upright(low: (f64, f64), high: (f64, f64)) -> Self {
        Self {
            x: 0.5 * (low.0 + high.0),
            y: 0.5 * (low.1 + high.1),
            axis: (1.0, 0.0),
            half_length: 0.5 * (high.0 - low.0),
            half_width: 0.5 * (high.1 - low.1),
        }
    }

    /// The world point at (`u`, `v`) metres from the centre along the two sides.
    pub fn point(&self, u: f64, v: f64) -> (f64, f64) {
        let (ax, ay) = self.axis;
        (self.x + u * ax - v * ay, self.y + u * ay + v * ax)
    }

    /// The corners, counter-clockwise.
    pub fn corners(&self) -> [(f64, f64); 4] {
        let (u, v) = (self.half_length, self.half_width);
        [(-u, -v), (u, -v), (u, v), (-u, v)].map(|(u, v)| self.point(u, v))
    }

    /// The sides, counter-clockwise: the inside is on the left of each.
    pub fn edges(&self) -> [Segment; 4] {
        let [a, b, c, d] = self.corners();
        [(a, b), (b, c), (c, d), (d, a)].map(|(a, b)| Segment { a, b })
    }

    /// The distance from a point to the box; 0 inside.
    pub fn distance(&self, (x, y): (f64, f64)) -> f64 {
        let (px, py) = (x - self.x, y - self.y);
        let (ax, ay) = self.axis;
        let beyond_u = (px * ax + py * ay).abs() - self.half_length;
        let beyond_v = (py * ax - px * ay).abs() - self.half_width;
        libm::hypot(beyond_u.max(0.0), beyond_v.max(0.0))
    }
}
