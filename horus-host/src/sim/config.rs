//! What a simulation is made from.

use super::Lidar;

/// Everything a [`Simulation`](super::Simulation) depends on.
#[derive(Debug, Clone, PartialEq)]
pub struct SimConfig {
    /// Seed of the building, the people and the noise.
    pub seed: u64,
    /// Time of the first scan, in nanoseconds.
    pub start_ns: u64,
    /// Time from one scan to the next, in nanoseconds.
    pub tick_ns: u64,
    /// The number of scans.
    pub ticks: u32,
    /// The number of people at most; fewer if there is no room for them to walk without running
    /// into the robot.
    pub people: usize,
    /// The sensor.
    pub lidar: Lidar,
}

impl Default for SimConfig {
    /// 60 s at 10 Hz from 1 s on, 12 people, the default [`Lidar`], seed 1.
    fn default() -> Self {
        Self {
            seed: 1,
            start_ns: 1_000_000_000,
            tick_ns: 100_000_000,
            ticks: 600,
            people: 12,
            lidar: Lidar::default(),
        }
    }
}
