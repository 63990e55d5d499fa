//! A smooth closed line through all rooms.

use super::Pose;
use super::floor_plan::{FloorPlan, Room};

/// Distance in front of and behind a door within which the robot heads straight through it, before
/// the bends are rounded; metres.
const APPROACH: f64 = 0.75;
/// How far from a bend rounding may begin, in metres.
const ROUNDING: f64 = 0.5;
/// Bends of less than this are left as they are, in radians.
const STRAIGHT: f64 = 1e-6;

/// A closed line of straight pieces and arcs that join without a kink.
#[derive(Debug, Clone)]
pub(super) struct Circuit {
    pieces: Vec<Piece>,
    length: f64,
}

/// A straight piece (curvature 0) or an arc.
#[derive(Debug, Clone, Copy)]
struct Piece {
    /// Arc length of the circuit at which the piece starts, in metres.
    at: f64,
    start: Pose,
    /// In radians per metre, positive to the left.
    curvature: f64,
}

impl Piece {
    /// The pose `s` metres behind the start.
    fn pose(&self, s: f64) -> Pose {
        let Pose { x, y, theta } = self.start;
        let (sin, cos) = libm::sincos(theta);
        let k = self.curvature;
        if k == 0.0 {
            return Pose {
                x: x + s * cos,
                y: y + s * sin,
                theta,
            };
        }
        let (sin_end, cos_end) = libm::sincos(theta + k * s);
        Pose {
            x: x + (sin_end - sin) / k,
            y: y - (cos_end - cos) / k,
            theta: theta + k * s,
        }
    }
}

impl Circuit {
    /// The line through the doors of the tour, straight from door to door and rounded at the
    /// bends.
    pub fn new(plan: &FloorPlan) -> Self {
        let corners = way_points(plan);
        let n = corners.len();
        let legs: Vec<Leg> = (0..n)
            .map(|i| Leg::between(corners[i], corners[(i + 1) % n]))
            .collect();
        // At most half of either leg, so that neighbouring arcs do not meet.
        let rounding = |i: usize| {
            let legs = [legs[(i + n - 1) % n].length, legs[i % n].length];
            legs.iter().fold(ROUNDING, |least, leg| least.min(0.5 * leg))
        };
        let mut pieces = Vec::with_capacity(2 * n);
        let mut length = 0.0;
        for (i, leg) in legs.iter().enumerate() {
            let (begin, end) = (rounding(i), leg.length - rounding(i + 1));
            pieces.push(Piece {
                at: length,
                start: leg.pose(corners[i], begin),
                curvature: 0.0,
            });
            length += end - begin;

            let turn = leg.turn_to(&legs[(i + 1) % n]);
            if turn.abs() > STRAIGHT {
                let radius = rounding(i + 1) / libm::tan(0.5 * turn.abs());
                pieces.push(Piece {
                    at: length,
                    start: leg.pose(corners[i], end),
                    curvature: turn.signum() / radius,
                });
                length += radius * turn.abs();
            }
        }
        Self { pieces, length }
    }

    /// Length of the whole circuit, in metres.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// The pose `s` metres along the circuit, any number of rounds; theta in -pi..=pi.
    pub fn pose(&self, s: f64) -> Pose {
        let s = s - self.length * libm::floor(s / self.length);
        let next = self.pieces.partition_point(|piece| piece.at <= s);
        let piece = &self.pieces[next.saturating_sub(1)];
        let pose = piece.pose(s - piece.at);
        Pose {
            theta: libm::remainder(pose.theta, std::f64::consts::TAU),
            ..pose
        }
    }
}

/// The points in front of and behind every door of the tour.
fn way_points(plan: &FloorPlan) -> Vec<(f64, f64)> {
    let next = plan.tour.iter().cycle().skip(1);
    plan.tour
        .iter()
        .zip(next)
        .filter_map(|(&from, &to)| passage(plan, from, to))
        .flatten()
        .collect()
}

/// The points in front of and behind the door from one room to another; `None` without a door.
pub(super) fn passage(plan: &FloorPlan, from: Room, to: Room) -> Option<[(f64, f64); 2]> {
    let (x, y) = plan.door(from, to)?;
    let step = |from: usize, to: usize| APPROACH * (to as f64 - from as f64);
    let (dx, dy) = (step(from.0, to.0), step(from.1, to.1));
    Some([(x - dx, y - dy), (x + dx, y + dy)])
}

/// The straight way from one corner to the next.
struct Leg {
    direction: (f64, f64),
    length: f64,
}

impl Leg {
    fn between(from: (f64, f64), to: (f64, f64)) -> Self {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let length = libm::hypot(dx, dy);
        Self {
            direction: (dx / length, dy / length),
            length,
        }
    }

    /// The pose `s` metres behind the start.
    fn pose(&self, start: (f64, f64), s: f64) -> Pose {
        let (dx, dy) = self.direction;
        Pose {
            x: start.0 + dx * s,
            y: start.1 + dy * s,
            theta: libm::atan2(dy, dx),
        }
    }

    /// The angle from this leg to the next, positive to the left.
    fn turn_to(&self, next: &Self) -> f64 {
        let ((ax, ay), (bx, by)) = (self.direction, next.direction);
        libm::atan2(ax * by - ay * bx, ax * bx + ay * by)
    }
}
