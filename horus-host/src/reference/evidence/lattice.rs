/// Where cells lie: rows along x, columns along y. Cell (row, col) is stored at `col * rows + row`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lattice {
    /// Cells along x.
    pub rows: u32,
    /// Cells along y.
    pub cols: u32,
    /// Metres per cell.
    pub cell_size: f32,
    /// x, y (metres) and heading (radians) of the corner of cell (0, 0) in the lattice's frame.
    pub pose: [f32; 3],
}

impl Lattice {
    /// Every cell in the order of storage.
    pub fn cells(&self) -> impl Iterator<Item = (u32, u32)> + use<> {
        let rows = self.rows;
        (0..self.cols).flat_map(move |col| (0..rows).map(move |row| (row, col)))
    }

    /// Number of cells.
    pub fn len(&self) -> usize {
        self.rows as usize * self.cols as usize
    }

    /// Whether there are no cells.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Index of a cell; `None` outside.
    pub fn index(&self, row: i64, col: i64) -> Option<usize> {
        let inside = (0..i64::from(self.rows)).contains(&row) && (0..i64::from(self.cols)).contains(&col);
        inside.then(|| (col * i64::from(self.rows) + row) as usize)
    }

    /// The centre of a cell in f32, as it decides which beam covers it.
    pub(super) fn center(&self, row: u32, col: u32) -> [f32; 2] {
        let [px, py, theta] = self.pose;
        let (c, s) = (libm::cosf(theta), libm::sinf(theta));
        let x = (row as f32 + 0.5) * self.cell_size;
        let y = (col as f32 + 0.5) * self.cell_size;
        [px + (c * x - s * y), py + (s * x + c * y)]
    }
}
