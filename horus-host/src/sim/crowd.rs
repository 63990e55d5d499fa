//! People who keep out of the robot's way.

use super::circuit::passage;
use super::floor_plan::{FloorPlan, HALF_WALL, Room};
use super::random::{Random, Use};
use super::{Drive, Person, World};

/// The least distance from a person's way to walls and furniture, in metres, beside the radius.
const WALL_CLEARANCE: f64 = 0.06;
/// The least distance between a person and the robot, in metres, beside both radii.
const ROBOT_CLEARANCE: f64 = 0.2;
/// A person that comes this near to the robot is near, in metres between centres.
const NEAR: f64 = 2.0;
/// Ways tried for each person.
const TRIES: usize = 300;
/// The least distance between two people, in metres, beside both radii.
const PEOPLE_CLEARANCE: f64 = 0.1;
/// Walks are compared at this interval, in seconds. Between two comparisons, two people come at
/// most 0.06 m nearer (1.2 m/s each for half the interval), which the clearances allow for.
const STEP: f64 = 0.05;
/// How long the walks are compared, in seconds.
const HORIZON: f64 = 600.0;
/// The shortest way, in metres.
const SHORTEST_WAY: f64 = 1.0;
/// Spacing of the points of a way that are compared with the furniture, in metres. Less than
/// twice the clearance, so that nothing is touched between two of them.
const WAY_STEP: f64 = 0.1;

/// At most `count` people in rooms the robot visits within `seconds` (of which the first 600
/// count). Everybody's way is clear of
/// walls and furniture, passes within 2 m of the robot and touches neither it nor anybody else;
/// those for whom no such way is found stay at home.
pub(super) fn crowd(world: &World, drive: &Drive, seed: u64, count: usize, seconds: f64) -> Vec<Person> {
    let mut random = Random::new(seed, Use::Crowd);
    let times: Vec<f64> = (0..=(seconds.min(HORIZON) / STEP) as u32)
        .map(|i| f64::from(i) * STEP)
        .collect();
    let robot: Vec<(f64, f64)> = times
        .iter()
        .map(|&t| drive.pose_at(t))
        .map(|pose| (pose.x, pose.y))
        .collect();
    let mut people: Vec<Person> = Vec::new();
    for _ in 0..count {
        let somebody = (0..TRIES).find_map(|_| {
            let meeting = robot[random.below(robot.len())];
            let room = world.plan().room_at(meeting)?;
            let person = walker(world.plan(), room, &mut random)?;
            let fits = is_way_clear(world, &person)
                && keeps_from_robot(&person, &times, &robot)
                && people.iter().all(|other| keeps_from(&person, other, &times));
            fits.then_some(person)
        });
        people.extend(somebody);
    }
    people
}

/// Somebody who walks within a room or, as often, through one of its doors.
fn walker(plan: &FloorPlan, room: Room, random: &mut Random) -> Option<Person> {
    let radius = random.between(0.2, 0.3);
    let mut way = vec![point_in(plan, room, radius, random)];
    if random.chance(0.5) {
        let neighbours: Vec<_> = plan
            .walls
            .iter()
            .filter(|wall| wall.door_centre().is_some())
            .filter_map(|wall| match wall.rooms {
                [Some(a), Some(b)] if a == room => Some(b),
                [Some(a), Some(b)] if b == room => Some(a),
                _ => None,
            })
            .collect();
        let next = *neighbours.get(random.below(neighbours.len()))?;
        way.extend(passage(plan, room, next)?);
        way.push(point_in(plan, next, radius, random));
    } else {
        way.push(point_in(plan, room, radius, random));
    }
    let speed = random.between(0.6, 1.2);
    let person = Person::new(way, speed, radius);
    let length = person.length();
    let head_start = random.between(0.0, 2.0 * length);
    (length >= SHORTEST_WAY).then(|| person.starting_at(head_start))
}

fn point_in(plan: &FloorPlan, room: Room, radius: f64, random: &mut Random) -> (f64, f64) {
    let [low, high] = plan.corners(room);
    let margin = HALF_WALL + radius + WALL_CLEARANCE;
    (
        random.between(low.0 + margin, high.0 - margin),
        random.between(low.1 + margin, high.1 - margin),
    )
}

fn is_way_clear(world: &World, person: &Person) -> bool {
    let steps = libm::ceil(person.length() / WAY_STEP) as u32;
    (0..=steps).all(|i| {
        let (x, y) = person.point(f64::from(i) * WAY_STEP);
        world.clearance(x, y) >= person.radius() + WALL_CLEARANCE
    })
}

/// True if the person passes near the robot but not too near.
fn keeps_from_robot(person: &Person, times: &[f64], robot: &[(f64, f64)]) -> bool {
    let apart = times.iter().zip(robot).map(|(&t, &(x, y))| {
        let disc = person.disc_at(t);
        libm::hypot(disc.x - x, disc.y - y)
    });
    let nearest = apart.fold(f64::INFINITY, f64::min);
    let least = Drive::ROBOT_RADIUS + person.radius() + ROBOT_CLEARANCE;
    (least..NEAR).contains(&nearest)
}

/// True if two people never touch.
fn keeps_from(person: &Person, other: &Person, times: &[f64]) -> bool {
    let least = person.radius() + other.radius() + PEOPLE_CLEARANCE;
    times.iter().all(|&t| {
        let (a, b) = (person.disc_at(t), other.disc_at(t));
        libm::hypot(a.x - b.x, a.y - b.y) >= least
    })
}
