mod costs;
mod footprint;
mod grid;
mod scan;
mod walk;
mod window;

use super::{OccupancyGrid, Pose2D};

/// A small generator, so that every run tests the same numbers (Knuth's 64-bit LCG).
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, limit: u32) -> u32 {
        self.0 = self.0.wrapping_mul(6364136223846793005);
        self.0 = self.0.wrapping_add(1442695040888963407);
        ((self.0 >> 33) % u64::from(limit)) as u32
    }

    /// Uniform in `low..high`, in 2^24 steps.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * f64::from(self.below(1 << 24)) / f64::from(1 << 24)
    }
}

/// A grid of 1 m cells with its corner at the world's origin, drawn with the highest y first: `?` unknown, `.` 0,
/// `#` 100, a digit times ten otherwise.
fn picture(rows: &[&str]) -> OccupancyGrid {
    let width = rows[0].len() as u32;
    let mut grid = OccupancyGrid::new(width, rows.len() as u32, 1.0, Pose2D::default());
    for (gy, row) in rows.iter().rev().enumerate() {
        for (gx, cell) in row.chars().enumerate() {
            let value = match cell {
                '?' => -1,
                '.' => 0,
                '#' => 100,
                digit => digit.to_digit(10).unwrap() as i8 * 10,
            };
            assert!(grid.set_occupancy(gx as u32, gy as u32, value));
        }
    }
    grid
}
