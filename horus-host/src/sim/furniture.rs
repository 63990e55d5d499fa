//! Furniture that leaves the robot's way free.

use super::floor_plan::{FloorPlan, HALF_WALL, ROOMS, Room};
use super::random::Random;
use super::{Disc, OrientedBox};

/// The least distance from furniture to the robot's way, in metres.
const WAY_CLEARANCE: f64 = 0.55;
/// The least distance from furniture to the centre of a door, in metres.
const DOOR_CLEARANCE: f64 = 1.0;
/// Pieces tried per room; some do not fit.
const TRIES: usize = 14;
/// Pieces placed in a room at most.
const MOST_PIECES: usize = 5;
/// Radius of a table's legs, in metres. A lidar near the floor sees nothing else of it.
const LEG_RADIUS: f64 = 0.03;

/// What stands in the rooms.
#[derive(Debug, Default)]
pub(super) struct Furniture {
    pub boxes: Vec<OrientedBox>,
    pub discs: Vec<Disc>,
}

enum Kind {
    Cabinet,
    Crate,
    Table,
    Plant,
}

impl Furniture {
    /// Furnishes every room. `way` are points along the robot's way, closely spaced.
    pub fn new(plan: &FloorPlan, way: &[(f64, f64)], random: &mut Random) -> Self {
        let mut keep_clear: Vec<((f64, f64), f64)> =
            way.iter().map(|&point| (point, WAY_CLEARANCE)).collect();
        let doors = plan.walls.iter().filter_map(|wall| wall.door_centre());
        keep_clear.extend(doors.map(|centre| (centre, DOOR_CLEARANCE)));

        let mut furniture = Self::default();
        for column in 0..ROOMS {
            for row in 0..ROOMS {
                furniture.furnish(plan, (column, row), &keep_clear, random);
            }
        }
        furniture
    }

    fn furnish(
        &mut self,
        plan: &FloorPlan,
        room: Room,
        keep_clear: &[((f64, f64), f64)],
        random: &mut Random,
    ) {
        let [(left, bottom), (right, top)] = plan.corners(room);
        let low = (left + HALF_WALL, bottom + HALF_WALL);
        let high = (right - HALF_WALL, top - HALF_WALL);
        let mut placed: Vec<OrientedBox> = Vec::new();
        for _ in 0..TRIES {
            let (kind, place) = candidate(low, high, random);
            // Circles around both are a coarse test, which only keeps pieces farther apart.
            let touches = placed.iter().any(|other| {
                let apart = libm::hypot(place.x - other.x, place.y - other.y);
                apart < circumradius(&place) + circumradius(other)
            });
            let inside = |(x, y)| low.0 <= x && x <= high.0 && low.1 <= y && y <= high.1;
            let in_room = place.corners().into_iter().all(inside);
            let is_clear = keep_clear
                .iter()
                .all(|&(point, clearance)| place.distance(point) >= clearance);
            if touches || !in_room || !is_clear {
                continue;
            }
            placed.push(place);
            self.put(kind, place);
            if placed.len() == MOST_PIECES {
                break;
            }
        }
    }

    fn put(&mut self, kind: Kind, place: OrientedBox) {
        match kind {
            Kind::Cabinet | Kind::Crate => self.boxes.push(place),
            Kind::Table => self.discs.extend(place.corners().map(|(x, y)| Disc {
                x,
                y,
                radius: LEG_RADIUS,
            })),
            Kind::Plant => self.discs.push(Disc {
                x: place.x,
                y: place.y,
                radius: place.half_width,
            }),
        }
    }
}

/// A piece of furniture somewhere in a room, not yet known to fit.
fn candidate(low: (f64, f64), high: (f64, f64), random: &mut Random) -> (Kind, OrientedBox) {
    let (kind, half_length, half_width) = match random.below(6) {
        0..=2 => (Kind::Cabinet, random.between(0.4, 1.0), random.between(0.2, 0.3)),
        3 => (Kind::Crate, random.between(0.25, 0.5), random.between(0.2, 0.4)),
        4 => (Kind::Table, random.between(0.5, 0.8), random.between(0.35, 0.45)),
        _ => {
            let radius = random.between(0.12, 0.25);
            (Kind::Plant, radius, radius)
        }
    };
    let x = random.between(low.0, high.0);
    let y = random.between(low.1, high.1);
    let (x, y, axis) = match kind {
        // Cabinets stand with their back to a wall.
        Kind::Cabinet => match random.below(4) {
            0 => (x, low.1 + half_width, (1.0, 0.0)),
            1 => (x, high.1 - half_width, (1.0, 0.0)),
            2 => (low.0 + half_width, y, (0.0, 1.0)),
            _ => (high.0 - half_width, y, (0.0, 1.0)),
        },
        _ => {
            let (sin, cos) = libm::sincos(random.between(0.0, std::f64::consts::PI));
            (x, y, (cos, sin))
        }
    };
    let place = OrientedBox {
        x,
        y,
        axis,
        half_length,
        half_width,
    };
    (kind, place)
}

fn circumradius(place: &OrientedBox) -> f64 {
    libm::hypot(place.half_length, place.half_width)
}
