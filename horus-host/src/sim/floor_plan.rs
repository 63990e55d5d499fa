//! Rooms and the doors between them.

use super::random::Random;

/// Rooms along each axis.
pub(super) const ROOMS: usize = 4;
/// Length of the building along each axis, in metres.
pub(super) const SIZE: f64 = 20.0;
/// Half the thickness of every wall, in metres.
pub(super) const HALF_WALL: f64 = 0.06;

/// How far a wall may lie from its place in an even division, in metres.
const WALL_SHIFT: f64 = 0.4;
/// The least distance from the centre of a door or window to a crossing wall, in metres.
const CORNER_DISTANCE: f64 = 1.1;
const DOOR_WIDTHS: (f64, f64) = (0.95, 1.1);
const WINDOW_WIDTHS: (f64, f64) = (1.2, 1.8);
/// The share of neighbouring rooms off the circuit that are connected, too.
const SIDE_DOORS: f64 = 0.35;
/// The share of outside walls with a window.
const WINDOWS: f64 = 0.4;

/// A tour of all rooms (column, row) that ends where it begins.
const TOUR: [(usize, usize); ROOMS * ROOMS] = [
    (0, 0),
    (1, 0),
    (2, 0),
    (3, 0),
    (3, 1),
    (3, 2),
    (3, 3),
    (2, 3),
    (2, 2),
    (2, 1),
    (1, 1),
    (1, 2),
    (1, 3),
    (0, 3),
    (0, 2),
    (0, 1),
];

/// A room: column and row, from the lower left.
pub(super) type Room = (usize, usize);

/// The direction of a wall.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Along {
    X,
    Y,
}

/// A stretch of wall between two crossing walls: the one left of or below a room, or at the far
/// side of the building.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct WallSpan {
    pub along: Along,
    /// The y of a wall along x, the x of a wall along y.
    pub at: f64,
    /// Where it starts and ends along its direction.
    pub span: (f64, f64),
    /// Centre and width of the door or window in it.
    pub opening: Option<(f64, f64)>,
    /// The rooms on its lower and upper side; `None` outside.
    pub rooms: [Option<Room>; 2],
}

impl WallSpan {
    /// The centre of its door; `None` if it has none or leads outside.
    pub fn door_centre(&self) -> Option<(f64, f64)> {
        let [Some(_), Some(_)] = self.rooms else {
            return None;
        };
        let (centre, _) = self.opening?;
        Some(match self.along {
            Along::X => (centre, self.at),
            Along::Y => (self.at, centre),
        })
    }
}

/// The rooms of a building, the walls around them, and a tour through all of them.
#[derive(Debug, Clone)]
pub(super) struct FloorPlan {
    /// The x of the walls along y, ascending.
    xs: [f64; ROOMS + 1],
    /// The y of the walls along x, ascending.
    ys: [f64; ROOMS + 1],
    pub walls: Vec<WallSpan>,
    pub tour: Vec<Room>,
}

impl FloorPlan {
    pub fn new(random: &mut Random) -> Self {
        let mut lines = || {
            let mut lines = [0.0; ROOMS + 1];
            for (i, line) in lines.iter_mut().enumerate() {
                *line = SIZE * i as f64 / ROOMS as f64;
                if (1..ROOMS).contains(&i) {
                    *line += random.between(-WALL_SHIFT, WALL_SHIFT);
                }
            }
            lines
        };
        let (xs, ys) = (lines(), lines());
        let tour = tour(random);
        let mut plan = Self {
            xs,
            ys,
            walls: Vec::new(),
            tour,
        };
        for along in [Along::X, Along::Y] {
            for line in 0..=ROOMS {
                for place in 0..ROOMS {
                    let wall = plan.wall(along, line, place, random);
                    plan.walls.push(wall);
                }
            }
        }
        plan
    }

    /// Lower left and upper right corner of a room, at the centre lines of its walls.
    pub fn corners(&self, (column, row): Room) -> [(f64, f64); 2] {
        [
            (self.xs[column], self.ys[row]),
            (self.xs[column + 1], self.ys[row + 1]),
        ]
    }

    /// The room that holds a point.
    pub fn room_at(&self, (x, y): (f64, f64)) -> Option<Room> {
        let place = |lines: &[f64], at: f64| lines.windows(2).position(|w| w[0] <= at && at < w[1]);
        place(&self.xs, x).zip(place(&self.ys, y))
    }

    /// The centre of the door between two rooms, whichever way round.
    pub fn door(&self, from: Room, to: Room) -> Option<(f64, f64)> {
        let connects =
            |wall: &&WallSpan| wall.rooms == [Some(from), Some(to)] || wall.rooms == [Some(to), Some(from)];
        self.walls.iter().find(connects)?.door_centre()
    }

    /// The wall on line `line` beside the rooms at `place` along it.
    fn wall(&self, along: Along, line: usize, place: usize, random: &mut Random) -> WallSpan {
        let room = |line: usize| match along {
            _ if line >= ROOMS => None,
            Along::X => Some((place, line)),
            Along::Y => Some((line, place)),
        };
        let (across, span) = match along {
            Along::X => (&self.ys, &self.xs),
            Along::Y => (&self.xs, &self.ys),
        };
        let span = (span[place], span[place + 1]);
        let rooms = [line.checked_sub(1).and_then(room), room(line)];
        let (is_open, widths) = match rooms {
            [Some(a), Some(b)] => {
                let side_door = random.chance(SIDE_DOORS);
                (side_door || self.on_tour(a, b), DOOR_WIDTHS)
            }
            _ => (random.chance(WINDOWS), WINDOW_WIDTHS),
        };
        let centre = random.between(span.0 + CORNER_DISTANCE, span.1 - CORNER_DISTANCE);
        let width = random.between(widths.0, widths.1);
        WallSpan {
            along,
            at: across[line],
            span,
            opening: is_open.then_some((centre, width)),
            rooms,
        }
    }

    /// True if the tour leads from one of the rooms straight to the other.
    fn on_tour(&self, a: Room, b: Room) -> bool {
        let next = self.tour.iter().cycle().skip(1);
        self.tour
            .iter()
            .zip(next)
            .any(|(&from, &to)| (from, to) == (a, b) || (to, from) == (a, b))
    }
}

/// The tour turned, mirrored and started at random.
fn tour(random: &mut Random) -> Vec<Room> {
    let (swap, flip_x, flip_y, reverse) = (
        random.chance(0.5),
        random.chance(0.5),
        random.chance(0.5),
        random.chance(0.5),
    );
    let flip = |flip: bool, i: usize| if flip { ROOMS - 1 - i } else { i };
    let mut tour = TOUR.map(|(column, row)| {
        let (column, row) = if swap { (row, column) } else { (column, row) };
        (flip(flip_x, column), flip(flip_y, row))
    });
    if reverse {
        tour.reverse();
    }
    tour.rotate_left(random.below(TOUR.len()));
    tour.to_vec()
}
