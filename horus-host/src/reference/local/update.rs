/// What an update of a local map did.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LocalUpdate {
    /// Whole cells the window moved along x and y.
    pub shift: [i32; 2],
    /// Odometry sensors that are configured but were not in the state.
    pub missing_odometries: u32,
    /// Lidars whose scans were drawn.
    pub lidars: u32,
    /// Lidars that are configured but were not in the state.
    pub missing_lidars: u32,
    /// Lidars whose scans had no ranges.
    pub empty_lidars: u32,
    /// Lidars whose numbers could not be used.
    pub invalid_lidars: u32,
    /// Beams that marked a cell of the map.
    pub marks: u32,
    /// Beams that were NaN or -inf.
    pub ignored: u32,
}
