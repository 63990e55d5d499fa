/// Cells that wait to be coded: all of them are equal, or all equal the cell below them.
#[derive(Clone, Copy, Default)]
pub(super) struct Segment {
    /// The first cell.
    pub value: u8,
    /// Number of cells.
    pub len: u32,
    /// How many of them are equal, up to the first that is not.
    run: u32,
    /// How many of them equal the cell below, up to the first that does not.
    copy: u32,
}

impl Segment {
    /// A segment of one cell.
    #[inline]
    pub fn starting_with(cell: u8, is_copy: bool) -> Self {
        Self {
            value: cell,
            len: 1,
            run: 1,
            copy: u32::from(is_copy),
        }
    }

    /// Adds a cell; false if it belongs to the next segment.
    #[inline]
    pub fn add(&mut self, cell: u8, is_copy: bool) -> bool {
        let copies = is_copy && self.copy == self.len;
        let runs = cell == self.value && self.run == self.len;
        if self.len == 0 || !(copies || runs) {
            return false;
        }
        self.len += 1;
        self.copy += u32::from(copies);
        self.run += u32::from(runs);
        true
    }

    /// All its cells equal the cell below them.
    pub fn is_copy(&self) -> bool {
        self.copy == self.len
    }
}
