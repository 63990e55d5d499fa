//! Seeded random numbers.

use rand_pcg::Pcg32;
use rand_pcg::rand_core::RngCore;

/// What random numbers are used for. Each use has a generator of its own, so that a change in one
/// leaves the others as they are.
#[derive(Debug, Clone, Copy)]
pub(super) enum Use {
    Building = 1,
    Crowd = 2,
    Lidar = 3,
}

/// A random number generator that gives the same numbers on every machine.
#[derive(Debug, Clone)]
pub(super) struct Random(Pcg32);

impl Random {
    pub fn new(seed: u64, purpose: Use) -> Self {
        Self(Pcg32::new(seed, purpose as u64))
    }

    /// Uniform in 0..1.
    pub fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 * (1.0 / (1_u64 << 53) as f64)
    }

    /// Uniform in `low..high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Uniform in `0..count`; 0 if `count` is 0.
    pub fn below(&mut self, count: usize) -> usize {
        (self.unit() * count as f64) as usize
    }

    /// True with the given probability.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.unit() < probability
    }

    /// Normally distributed with mean 0 and deviation 1 (Box-Muller).
    pub fn gaussian(&mut self) -> f64 {
        let radius = libm::sqrt(-2.0 * libm::log(1.0 - self.unit()));
        radius * libm::cos(std::f64::consts::TAU * self.unit())
    }
}
