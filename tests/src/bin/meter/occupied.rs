use horus_core::grid::{OCCUPIED_FROM, OccupancyGrid};

/// `u32` words for the bits of the largest grid.
pub const WORDS: usize = (200usize * 200).div_ceil(32);

/// Which cells of a grid were occupied, a bit each.
pub struct Occupied([u32; WORDS]);

impl Occupied {
    /// None.
    pub const fn empty() -> Self {
        Self([0; WORDS])
    }

    /// Takes the cells as they are; returns how many are occupied now and were not, or were and
    /// are not.
    pub fn follow(&mut self, grid: &OccupancyGrid<&mut [i8]>) -> u32 {
        let mut changes = 0;
        for (word, cells) in self.0.iter_mut().zip(grid.data().chunks(32)) {
            let bit = |(i, value): (usize, &i8)| u32::from(*value >= OCCUPIED_FROM) << i;
            let now: u32 = cells.iter().enumerate().map(bit).sum();
            changes += (*word ^ now).count_ones();
            *word = now;
        }
        changes
    }
}
