use crate::error::Error;

/// How far the three masses of a cell may be from summing to 1.
const SUM_TOLERANCE: f32 = 1e-5;

/// The belief masses of one cell as numbers: free, occupied, and what is left, uncertain.
///
/// The default, all zero, is the vacuous state: everything is uncertain.
///
/// ```
/// use horus_core::evidence::Masses;
///
/// let free = Masses::new(0.4, 0.0, 0.6)?;
/// assert_eq!((free.free(), free.uncertain()), (0.4, 0.6));
/// assert!(Masses::new(0.4, 0.4, 0.4).is_err());
/// # Ok::<(), horus_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Masses {
    free: f32,
    occupied: f32,
}

impl Masses {
    /// Nothing is known: the whole mass is uncertain.
    pub const VACUOUS: Self = Self {
        free: 0.0,
        occupied: 0.0,
    };

    /// Three masses, each 0 to 1, which sum to 1 within 1e-5; `uncertain` is kept as what the other
    /// two leave.
    ///
    /// # Errors
    /// [`Error::InvalidMasses`].
    pub fn new(free: f32, occupied: f32, uncertain: f32) -> Result<Self, Error> {
        let masses = Self::known(free, occupied)?;
        if (masses.uncertain() - uncertain).abs() <= SUM_TOLERANCE {
            Ok(masses)
        } else {
            Err(Error::InvalidMasses)
        }
    }

    /// Two masses, each 0 to 1, whose sum is at most 1 (within 1e-5); the rest is uncertain.
    ///
    /// # Errors
    /// [`Error::InvalidMasses`].
    pub fn known(free: f32, occupied: f32) -> Result<Self, Error> {
        let is_mass = |mass: f32| (0.0..=1.0).contains(&mass);
        if is_mass(free) && is_mass(occupied) && free + occupied <= 1.0 + SUM_TOLERANCE {
            Ok(Self { free, occupied })
        } else {
            Err(Error::InvalidMasses)
        }
    }

    /// Two masses that a cell holds.
    pub(crate) const fn of_cell(free: f32, occupied: f32) -> Self {
        Self { free, occupied }
    }

    /// Belief that the cell is free, 0 to 1.
    pub const fn free(&self) -> f32 {
        self.free
    }

    /// Belief that the cell is occupied, 0 to 1.
    pub const fn occupied(&self) -> f32 {
        self.occupied
    }

    /// The mass that says nothing, 0 to 1.
    pub fn uncertain(&self) -> f32 {
        let rest = (1.0 - self.free) - self.occupied;
        if rest > 0.0 { rest } else { 0.0 }
    }

    /// The pignistic probability that the cell is occupied: the uncertain mass split evenly, 0 to 1.
    pub fn pignistic(&self) -> f32 {
        self.occupied + 0.5 * self.uncertain()
    }

    /// The occupancy value of a cell: the pignistic probability in percent, 0 to 100, or
    /// [`UNKNOWN`](crate::grid::UNKNOWN) where more than `max_uncertain` is uncertain.
    pub fn occupancy(&self, max_uncertain: f32) -> i8 {
        // A cell at the limit is known, whatever rounding made of its masses: a step of 16 bits is 15 times this.
        const ROUNDING: f32 = 1e-6;
        if self.uncertain() > max_uncertain + ROUNDING {
            crate::grid::UNKNOWN
        } else {
            // 0.5 to 100.5: the cast rounds to the nearest percent, halves up.
            (self.pignistic() * 100.0 + 0.5) as i8
        }
    }
}
