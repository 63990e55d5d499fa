//! What the meter's maps show and its lidar sees: an office without end, a robot that drives a
//! circle in one of its rooms, a person who walks around in it.
//!
//! Lengths are in cells of [`RESOLUTION`] metres, angles in radians.

use horus_core::prelude::*;

/// Metres per cell.
pub const RESOLUTION: f32 = 0.05;
/// Beams of the lidar, one per degree.
pub const BEAMS: usize = 360;
/// Middle of the room that the robot drives in, along x and y.
pub const CENTRE: i32 = 150;
/// The lidar sees this far: 3.6 m.
const RANGE: f32 = 72.0;
/// Radius of the robot's circle; it moves one cell per tick.
const TRACK: f32 = 25.0;
/// The person: a disc on a circle of this radius.
const WALK: f32 = 14.0;
const PERSON: f32 = 4.0;

/// A building of 200 x 200 cells, repeated without end: rooms of 100 cells with walls two cells
/// thick, a door of 20 cells in each inner wall, six pieces of furniture per room.
#[derive(Clone, Debug)]
pub struct Office {
    /// A bit per cell, row after row.
    blocked: [u32; Self::WORDS],
}

impl Office {
    /// Cells per side of the building.
    pub const SIDE: i32 = 200;
    const WORDS: usize = (Self::SIDE * Self::SIDE) as usize / 32;
    const ROOM: i32 = 100;

    /// Nothing built yet, all bits zero.
    pub const fn empty() -> Self {
        Self {
            blocked: [0; Self::WORDS],
        }
    }

    /// Builds walls, doors and furniture; the robot's track stays free.
    pub fn build(&mut self) {
        let mut random = Random::new(27);
        for wall in (0..=Self::SIDE).step_by(Self::ROOM as usize) {
            self.fill(wall - 1, 0, wall + 1, Self::SIDE, true);
            self.fill(0, wall - 1, Self::SIDE, wall + 1, true);
        }
        let inner = Self::ROOM;
        for room in [0, Self::ROOM] {
            let door = room + 15 + random.below(50);
            self.fill(inner - 1, door, inner + 1, door + 20, false);
            let door = room + 15 + random.below(50);
            self.fill(door, inner - 1, door + 20, inner + 1, false);
        }
        for (x0, y0) in [(0, 0), (inner, 0), (0, inner), (inner, inner)] {
            for _ in 0..6 {
                let (w, h) = (3 + random.below(14), 3 + random.below(14));
                let (x, y) = (x0 + 6 + random.below(80), y0 + 6 + random.below(80));
                self.fill(x, y, x + w, y + h, true);
            }
        }
        for y in 0..Self::SIDE {
            for x in 0..Self::SIDE {
                let from_track = (x - CENTRE).pow(2) + (y - CENTRE).pow(2);
                if (18 * 18..=32 * 32).contains(&from_track) {
                    self.fill(x, y, x + 1, y + 1, false);
                }
            }
        }
    }

    /// Whether a cell of the endless office is an obstacle.
    pub fn is_blocked(&self, x: i32, y: i32) -> bool {
        let (word, bit) = Self::place(x, y);
        self.blocked.get(word).is_some_and(|w| w & bit != 0)
    }

    /// Obstacle cells of the building.
    pub fn obstacles(&self) -> u32 {
        self.blocked.iter().map(|word| word.count_ones()).sum()
    }

    fn place(x: i32, y: i32) -> (usize, u32) {
        let i = y.rem_euclid(Self::SIDE) * Self::SIDE + x.rem_euclid(Self::SIDE);
        (i as usize / 32, 1 << (i % 32))
    }

    fn fill(&mut self, x0: i32, y0: i32, x1: i32, y1: i32, blocked: bool) {
        for y in y0..y1 {
            for x in x0..x1 {
                let (word, bit) = Self::place(x, y);
                if let Some(word) = self.blocked.get_mut(word) {
                    *word = if blocked { *word | bit } else { *word & !bit };
                }
            }
        }
    }
}

/// Where the robot is at a tick, world frame: on its circle, heading along it.
pub fn robot(tick: u32) -> Pose2D {
    let angle = tick as f32 / TRACK;
    let (x, y) = on_circle(TRACK, angle);
    Pose2D::new(
        x * RESOLUTION,
        y * RESOLUTION,
        angle + core::f32::consts::FRAC_PI_2,
    )
}

fn on_circle(radius: f32, angle: f32) -> (f32, f32) {
    let centre = CENTRE as f32;
    (
        centre + radius * libm::cosf(angle),
        centre + radius * libm::sinf(angle),
    )
}

/// A lidar with range noise of 0.4 cells standard deviation.
#[derive(Clone, Debug)]
pub struct Lidar {
    random: Random,
    ranges: [f32; BEAMS],
}

impl Lidar {
    /// Has seen nothing yet.
    pub const fn new() -> Self {
        Self {
            random: Random::new(3),
            ranges: [0.0; BEAMS],
        }
    }

    /// What it sees from the robot's pose at a tick.
    pub fn measure(&mut self, office: &Office, tick: u32) -> LaserScan<'_> {
        let pose = robot(tick);
        let (x, y) = (pose.x / RESOLUTION, pose.y / RESOLUTION);
        let person = on_circle(WALK, 1.0 - tick as f32 / 30.0);
        for (beam, range) in self.ranges.iter_mut().enumerate() {
            let angle = pose.theta + beam as f32 * Self::INCREMENT;
            let (dx, dy) = (libm::cosf(angle), libm::sinf(angle));
            let is_hit = |along: &f32| {
                let (x, y) = (x + dx * along, y + dy * along);
                let (px, py) = (x - person.0, y - person.1);
                office.is_blocked(libm::floorf(x) as i32, libm::floorf(y) as i32)
                    || px * px + py * py <= PERSON * PERSON
            };
            let hit = (0..2 * RANGE as u32).map(|i| i as f32 * 0.5).find(is_hit);
            *range = hit.map_or(f32::INFINITY, |hit| {
                (hit + 0.8 * self.random.spread()).max(0.0) * RESOLUTION
            });
        }
        LaserScan {
            angle_min: 0.0,
            angle_increment: Self::INCREMENT,
            range_min: 0.0,
            range_max: RANGE * RESOLUTION,
            ranges: &self.ranges,
        }
    }

    const INCREMENT: f32 = core::f32::consts::TAU / BEAMS as f32;
}

impl Default for Lidar {
    fn default() -> Self {
        Self::new()
    }
}

/// The same numbers in every run.
#[derive(Clone, Debug)]
pub struct Random(u32);

impl Random {
    /// Starts a sequence.
    pub const fn new(seed: u32) -> Self {
        Self(seed)
    }

    /// A number from 0 up to, not including, `n`, which is above zero.
    pub fn below(&mut self, n: i32) -> i32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        ((self.0 >> 8) % n.max(1) as u32) as i32
    }

    /// Roughly normal, standard deviation 0.5.
    fn spread(&mut self) -> f32 {
        (0..3).map(|_| self.below(1000) as f32 / 1000.0 - 0.5).sum()
    }
}
