/// Which cells a straight walk between two cells visits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum WalkRule {
    /// One cell per step along the longer side; exactly between two cells, the one nearer to the start
    /// (Beluga's standard Bresenham).
    #[default]
    Standard,
    /// Every cell that the line between the two centres touches, corners included (Beluga's modified
    /// Bresenham). On an exact corner the cell along the longer side comes first.
    Supercover,
    /// As [`Standard`](Self::Standard), but exactly between two cells the one farther from the start
    /// (navground, nav2, and the scans of an [`OccupancyGrid`](crate::grid::OccupancyGrid)).
    Navground,
}

/// Where a walk turns when its line runs exactly between two cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Tie {
    /// Stay on the start's side: Beluga.
    Near,
    /// Move on: navground and nav2.
    Far,
}

impl Tie {
    /// What the error term of a walk with `n` dominant steps starts with.
    #[inline]
    pub(super) const fn start(self, n: u32) -> u32 {
        match self {
            Self::Near => n.saturating_sub(1) / 2,
            Self::Far => n / 2,
        }
    }
}
