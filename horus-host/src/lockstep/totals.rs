use std::time::Duration;

/// What a lockstep run has counted so far.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Totals {
    /// Ticks compared.
    pub ticks: u64,
    /// Occupancy and cost cells compared: two per cell and tick.
    pub cells_compared: u64,
    /// Cells that differed, and windows, scan reports and refusals that did.
    pub mismatches: u64,
    /// Time the core took to move the window, integrate the scans and update the costs.
    pub core_time: Duration,
    /// The same for the std version.
    pub std_time: Duration,
}

impl Totals {
    /// Mean time of the core per tick in microseconds; 0 before the first.
    pub fn core_us_per_tick(&self) -> f64 {
        self.us_per_tick(self.core_time)
    }

    /// Mean time of the std version per tick in microseconds; 0 before the first.
    pub fn std_us_per_tick(&self) -> f64 {
        self.us_per_tick(self.std_time)
    }

    fn us_per_tick(&self, time: Duration) -> f64 {
        time.as_secs_f64() * 1e6 / self.ticks.max(1) as f64
    }
}
