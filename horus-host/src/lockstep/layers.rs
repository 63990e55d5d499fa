/// One side's map after a tick: what is compared, logged and painted.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Layers {
    /// Whole cells the window has moved since the start, along x and y.
    pub offset: [i32; 2],
    /// Occupancy, row-major: -1 unknown, 0 free to 100 occupied.
    pub occupancy: Vec<i8>,
    /// Costs, row-major: 0 free to the lethal cost, 255 unknown.
    pub costs: Vec<u8>,
}

impl Layers {
    pub(super) fn new(cells: usize) -> Self {
        Self {
            offset: [0; 2],
            occupancy: Vec::with_capacity(cells),
            costs: Vec::with_capacity(cells),
        }
    }
}
