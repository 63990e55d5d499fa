//! Round obstacles.

/// A round obstacle: a person, a plant, the leg of a table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disc {
    /// Centre along x, in metres.
    pub x: f64,
    /// Centre along y, in metres.
    pub y: f64,
    /// Radius in metres.
    pub radius: f64,
}

impl Disc {
    /// The distance along the ray from (`x`, `y`) in the unit direction (`dx`, `dy`) at which it
    /// enters the disc; `None` if it misses or starts inside.
    pub fn ray(&self, (x, y): (f64, f64), (dx, dy): (f64, f64)) -> Option<f64> {
        let (cx, cy) = (self.x - x, self.y - y);
        let nearest = cx * dx + cy * dy;
        let aside = cx * dy - cy * dx;
        let inside = self.radius * self.radius - aside * aside;
        if inside < 0.0 {
            return None;
        }
        let distance = nearest - libm::sqrt(inside);
        (distance >= 0.0).then_some(distance)
    }

    /// The distance from a point to the disc; 0 inside.
    pub fn distance(&self, (x, y): (f64, f64)) -> f64 {
        (libm::hypot(self.x - x, self.y - y) - self.radius).max(0.0)
    }
}
