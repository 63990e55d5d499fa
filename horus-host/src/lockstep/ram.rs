/// Bytes of memory that the core uses, by purpose.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct RamUse {
    /// Occupancy, one byte per cell.
    pub cells: usize,
    /// The distance field, one or two bytes per cell.
    pub field: usize,
    /// Bits of sources and changes, and bookkeeping of the order of width + height.
    pub bits: usize,
    /// Kept costs, one byte per cell; 0 if none are kept.
    pub costs: usize,
    /// Working memory of a fixed size.
    pub scratch: usize,
    /// Tables that follow from the parameters.
    pub tables: usize,
    /// Slots of the scan's beams.
    pub beams: usize,
    /// One bit per cell for accumulating scans; 0 otherwise.
    pub seen: usize,
    /// A local map, one byte per cell, with its sensing state; 0 without one.
    pub local: usize,
    /// The handles over all this.
    pub handles: usize,
}

impl RamUse {
    /// All of it.
    pub fn total(&self) -> usize {
        self.cells
            + self.field
            + self.bits
            + self.costs
            + self.scratch
            + self.tables
            + self.beams
            + self.seen
            + self.local
            + self.handles
    }

    /// All of it per cell of the map.
    pub fn per_cell(&self) -> f64 {
        self.total() as f64 / self.cells.max(1) as f64
    }
}
