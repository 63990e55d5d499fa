/// Belief masses of one cell: free, occupied, uncertain; each 0 to 1, sum 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Masses {
    /// Belief that the cell is free.
    pub free: f64,
    /// Belief that the cell is occupied.
    pub occupied: f64,
    /// What says nothing.
    pub uncertain: f64,
}

impl Masses {
    /// Nothing is known.
    pub const VACUOUS: Self = Self::new(0.0, 0.0, 1.0);

    /// Three masses.
    pub const fn new(free: f64, occupied: f64, uncertain: f64) -> Self {
        Self {
            free,
            occupied,
            uncertain,
        }
    }

    /// Two masses; the rest is uncertain.
    pub const fn known(free: f64, occupied: f64) -> Self {
        Self::new(free, occupied, 1.0 - free - occupied)
    }

    /// The largest difference of two masses.
    pub fn distance(&self, other: &Self) -> f64 {
        let differences = [
            self.free - other.free,
            self.occupied - other.occupied,
            self.uncertain - other.uncertain,
        ];
        differences.iter().fold(0.0, |most, d| f64::max(most, d.abs()))
    }
}

impl Default for Masses {
    fn default() -> Self {
        Self::VACUOUS
    }
}
