//! People.

use super::Disc;

/// Somebody walking to and fro along a line of way points.
#[derive(Debug, Clone, PartialEq)]
pub struct Person {
    way: Vec<(f64, f64)>,
    /// Walking speed in m/s.
    speed: f64,
    /// How far along the way the walk starts, in metres.
    head_start: f64,
    radius: f64,
}

impl Person {
    /// Somebody of a radius in metres who walks at `speed` m/s.
    pub(super) fn new(way: Vec<(f64, f64)>, speed: f64, radius: f64) -> Self {
        Self {
            way,
            speed,
            head_start: 0.0,
            radius,
        }
    }

    /// The same person, but `head_start` metres on; beyond the length of the way, walking back.
    pub(super) fn starting_at(self, head_start: f64) -> Self {
        Self { head_start, ..self }
    }

    /// Radius in metres.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The way points between which the person walks, in the world frame.
    pub fn way(&self) -> &[(f64, f64)] {
        &self.way
    }

    /// The person `seconds` after the start, in the world frame.
    pub fn disc_at(&self, seconds: f64) -> Disc {
        let length = self.length();
        let walked = libm::fabs(self.head_start + self.speed * seconds);
        // There and back is twice the length; the second half is walked backwards.
        let round = libm::fmod(walked, 2.0 * length);
        let (x, y) = self.point(round.min(2.0 * length - round));
        Disc {
            x,
            y,
            radius: self.radius,
        }
    }

    /// The length of the way, in metres.
    pub(super) fn length(&self) -> f64 {
        self.legs().map(|(a, b)| distance(a, b)).sum()
    }

    /// The point `s` metres along the way.
    pub(super) fn point(&self, s: f64) -> (f64, f64) {
        let mut left = s;
        let mut last = self.way.first().copied().unwrap_or((0.0, 0.0));
        for (a, b) in self.legs() {
            let leg = distance(a, b);
            if left < leg {
                let part = left / leg;
                return (a.0 + part * (b.0 - a.0), a.1 + part * (b.1 - a.1));
            }
            left -= leg;
            last = b;
        }
        last
    }

    fn legs(&self) -> impl Iterator<Item = ((f64, f64), (f64, f64))> {
        self.way.windows(2).map(|pair| (pair[0], pair[1]))
    }
}

fn distance(a: (f64, f64), b: (f64, f64)) -> f64 {
    libm::hypot(b.0 - a.0, b.1 - a.1)
}
