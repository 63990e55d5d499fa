use super::{At, DenseGrid2};

/// A [`DenseGrid2`] whose values lie in one slice, row by row: `index = y * width + x`.
///
/// Source: Beluga `LinearGrid2`.
pub trait LinearGrid2: DenseGrid2 {
    /// All values, row-major, `width * height` of them.
    fn data(&self) -> &[Self::Data];

    /// Number of cells.
    #[inline]
    fn size(&self) -> usize {
        self.data().len()
    }

    /// The index of a cell; outside: `None`.
    #[inline]
    fn index_at(&self, at: impl At<Self>) -> Option<usize> {
        let cell = at.cell(self)?;
        self.contains(cell)
            .then(|| cell.y as usize * self.width() as usize + cell.x as usize)
    }
}
