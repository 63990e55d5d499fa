use super::field::FieldCell;
use super::tables::CostTables;
use crate::storage::{bitmap_words, words_per_row};

/// `u32` words of source and change bits that a cost map of this size takes.
///
/// ```
/// use horus_core::costmap::bit_words;
/// assert_eq!(bit_words(200, 200), 1400 + 1400 + 44 + 14);
/// ```
pub const fn bit_words(width: u32, height: u32) -> usize {
    let words = bitmap_words(width, height);
    2 * words + words.div_ceil(32) + 2 * words_per_row(width)
}

/// What a [`CostMap`](super::CostMap) needs beside the grid's cells, borrowed.
///
/// The contents do not matter; the lengths are checked when a cost map is made of it.
#[derive(Debug)]
pub struct CostBuffers<'a, F: FieldCell = u8> {
    /// [`bit_words`] words.
    pub bits: &'a mut [u32],
    /// One per cell.
    pub field: &'a mut [F],
    /// [`scratch_words`](super::scratch_words) words for the effective radius.
    pub scratch: &'a mut [u32],
    /// One byte per cell to have the costs kept as a slice; `None` to have them read through the
    /// map.
    pub costs: Option<&'a mut [u8]>,
    /// Tables of the parameters.
    pub tables: &'a mut CostTables<F>,
}

/// Storage for the grid and the cost map of `N` cells without kept cost bytes: one `static`.
///
/// `WORDS` is [`bit_words`]`(width, height)`, `SCRATCH`
/// [`scratch_words`](super::scratch_words)`(radius in cells)`.
///
/// ```
/// use horus_core::prelude::*;
/// use horus_core::costmap::bit_words;
///
/// // In firmware: a `static` behind a `StaticCell` or a `Mutex`; all bits zero, so it lies in .bss.
/// let mut buffers = CostMapBuffers::<{ 64 * 64 }, { bit_words(64, 64) }>::empty();
/// let (cells, cost_buffers) = buffers.split();
/// let grid = OccupancyGrid::new_in(cells, 64, 64, 0.05, Pose2D::default())?;
/// let map = CostMap::new_in(grid, cost_buffers, CostParams::default())?;
/// assert_eq!(map.cost(1.0, 1.0), Some(255), "unknown");
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct CostMapBuffers<const N: usize, const WORDS: usize, F: FieldCell = u8, const SCRATCH: usize = 512> {
    cells: [i8; N],
    field: [F; N],
    bits: [u32; WORDS],
    scratch: [u32; SCRATCH],
    tables: CostTables<F>,
}

macro_rules! empty {
    ($($field:ty),*) => {$(
        impl<const N: usize, const WORDS: usize, const SCRATCH: usize> CostMapBuffers<N, WORDS, $field, SCRATCH> {
            /// All bits zero.
            pub const fn empty() -> Self {
                Self {
                    cells: [0; N],
                    field: [0; N],
                    bits: [0; WORDS],
                    scratch: [0; SCRATCH],
                    tables: CostTables::EMPTY,
                }
            }
        }
    )*};
}
empty!(u8, u16);

impl<const N: usize, const WORDS: usize, F: FieldCell, const SCRATCH: usize>
    CostMapBuffers<N, WORDS, F, SCRATCH>
{
    /// The cells for the grid and the buffers for the cost map over it.
    pub fn split(&mut self) -> (&mut [i8], CostBuffers<'_, F>) {
        let buffers = CostBuffers {
            bits: &mut self.bits,
            field: &mut self.field,
            scratch: &mut self.scratch,
            costs: None,
            tables: &mut self.tables,
        };
        (&mut self.cells, buffers)
    }
}
