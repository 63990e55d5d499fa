/// A map of one byte per cell; the number is the one on the wire.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(u8)]
pub enum MapLayer {
    /// Occupancy, -1..=100 as bytes: 255 is unknown.
    Occupancy = 0,
    /// Costs, 0..=254, 255 unknown.
    Costs = 1,
}

impl MapLayer {
    /// Every layer, in the order of their numbers.
    pub const ALL: [Self; 2] = [Self::Occupancy, Self::Costs];

    /// The layer with this number.
    pub fn from_number(number: u8) -> Option<Self> {
        Self::ALL.get(usize::from(number)).copied()
    }

    /// The value of cells that come into view when the window moves.
    pub const fn unseen(self) -> u8 {
        match self {
            Self::Occupancy | Self::Costs => 255,
        }
    }
}
