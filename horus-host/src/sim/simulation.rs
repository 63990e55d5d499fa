//! The simulation.

use super::crowd::crowd;
use super::random::{Random, Use};
use super::{Disc, Drive, Person, SimConfig, SimTick, World};

/// A robot's drive through a building, one [`SimTick`] per scan.
///
/// # Examples
/// ```
/// use horus_host::sim::{SimConfig, Simulation};
///
/// let mut simulation = Simulation::new(SimConfig { seed: 7, ..SimConfig::default() });
/// let tick = simulation.next().unwrap();
/// assert_eq!((tick.stamp_ns, tick.ranges.len()), (1_000_000_000, 360));
/// assert_eq!(simulation.count(), 599);
/// ```
#[derive(Debug, Clone)]
pub struct Simulation {
    config: SimConfig,
    world: World,
    drive: Drive,
    people: Vec<Person>,
    noise: Random,
    next_tick: u32,
}

impl Simulation {
    /// Builds the building and sends the people for a walk. They keep out of the robot's way for
    /// the first ten minutes; in a longer simulation they may later walk into it.
    ///
    /// # Complexity
    /// The people's walks are tried against the robot's whole drive: linear in its duration and in
    /// the number of people.
    pub fn new(config: SimConfig) -> Self {
        let world = World::building(config.seed);
        let drive = Drive::through(&world);
        let seconds = f64::from(config.ticks) * config.tick_ns as f64 * 1e-9;
        let people = crowd(&world, &drive, config.seed, config.people, seconds);
        Self {
            noise: Random::new(config.seed, Use::Lidar),
            config,
            world,
            drive,
            people,
            next_tick: 0,
        }
    }

    /// What the simulation was made from.
    pub fn config(&self) -> &SimConfig {
        &self.config
    }

    /// The building.
    pub fn world(&self) -> &World {
        &self.world
    }

    /// The robot's drive; it starts at the first tick.
    pub fn drive(&self) -> &Drive {
        &self.drive
    }

    /// The people; they start walking at the first tick.
    pub fn people(&self) -> &[Person] {
        &self.people
    }
}

impl Iterator for Simulation {
    type Item = SimTick;

    fn next(&mut self) -> Option<SimTick> {
        if self.next_tick >= self.config.ticks {
            return None;
        }
        let elapsed_ns = self.config.tick_ns.saturating_mul(self.next_tick.into());
        let seconds = elapsed_ns as f64 * 1e-9;
        self.next_tick += 1;
        let robot = self.drive.pose_at(seconds);
        let people: Vec<Disc> = self.people.iter().map(|p| p.disc_at(seconds)).collect();
        let lidar = &self.config.lidar;
        Some(SimTick {
            stamp_ns: self.config.start_ns.saturating_add(elapsed_ns),
            robot,
            ranges: lidar.scan(&self.world, &people, &robot, &mut self.noise),
        })
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = (self.config.ticks - self.next_tick) as usize;
        (left, Some(left))
    }
}

impl ExactSizeIterator for Simulation {}
