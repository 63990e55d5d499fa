use super::super::MassCell;
use super::BinaryThresholds;
use crate::error::{Buffer, Error, require};
use crate::storage::{bitmap_words, words_per_row};

/// A binary map, borrowed: one bit per cell, set where it is occupied; rows start on a word.
///
/// Source: Isaac `EvidenceToBinaryMap`.
///
/// ```
/// use horus_core::evidence::{BinaryMap, BinaryThresholds, EvidenceU16, MassCell, Masses};
///
/// let free = EvidenceU16::from_masses(Masses::new(0.4, 0.0, 0.6)?);
/// let mut words = [0; 1];
/// let mut map = BinaryMap::new_in(&mut words, 2, 1)?;
/// map.take(&[free, EvidenceU16::VACUOUS], BinaryThresholds::default())?;
/// assert_eq!(map.is_occupied(0, 0), Some(false));
/// assert_eq!(map.is_occupied(1, 0), Some(true), "unknown, and nobody is optimistic");
/// # Ok::<(), horus_core::Error>(())
/// ```
#[derive(Debug)]
pub struct BinaryMap<'a> {
    words: &'a mut [u32],
    width: u32,
    height: u32,
}

impl<'a> BinaryMap<'a> {
    /// A map of free cells over at least [`bitmap_words`] words.
    ///
    /// # Errors
    /// [`Error::BufferTooSmall`]; [`Error::SizeOverflow`] if a `usize` does not hold the number of words.
    pub fn new_in(words: &'a mut [u32], width: u32, height: u32) -> Result<Self, Error> {
        if words_per_row(width).checked_mul(height as usize).is_none() {
            return Err(Error::SizeOverflow);
        }
        let needed = bitmap_words(width, height);
        require(Buffer::Bits, needed, words.len())?;
        let words = words.get_mut(..needed).unwrap_or_default();
        words.fill(0);
        Ok(Self { words, width, height })
    }

    /// Columns.
    pub const fn width(&self) -> u32 {
        self.width
    }

    /// Rows.
    pub const fn height(&self) -> u32 {
        self.height
    }

    /// Whether a cell is occupied; outside: `None`.
    pub fn is_occupied(&self, gx: u32, gy: u32) -> Option<bool> {
        if gx >= self.width || gy >= self.height {
            return None;
        }
        let word = self.words.get(self.word(gx, gy))?;
        Some(word >> (gx % 32) & 1 != 0)
    }

    /// Whether the cells of a row are occupied; none outside the map.
    pub fn row(&self, gy: u32) -> impl Iterator<Item = bool> + '_ {
        let per_row = words_per_row(self.width);
        // A row outside would make the product wrap where sizes have 32 bits.
        let start = if gy < self.height {
            gy as usize * per_row
        } else {
            self.words.len()
        };
        let words = self.words.get(start..start + per_row).unwrap_or_default();
        let (mut words, mut bits) = (words.iter(), 0);
        let columns = if words.len() > 0 { self.width } else { 0 };
        (0..columns).map(move |gx| {
            if gx.is_multiple_of(32) {
                bits = words.next().copied().unwrap_or(0);
            }
            let bit = bits & 1 != 0;
            bits >>= 1;
            bit
        })
    }

    /// All bits, row by row; rows start on a word, bit 0 first.
    pub fn words(&self) -> &[u32] {
        self.words
    }

    /// Replaces the map by what the cells of an evidence grid, row-major, are under the thresholds.
    ///
    /// # Errors
    /// As [`BinaryThresholds::validate`]; [`Error::LengthMismatch`] unless there is one cell each.
    /// Nothing changes then.
    ///
    /// # Complexity
    /// One read per cell, one write per word.
    pub fn take<M: MassCell>(&mut self, cells: &[M], thresholds: BinaryThresholds) -> Result<(), Error> {
        let decision = Decision::<M>::new(thresholds)?;
        let needed = self.width as usize * self.height as usize;
        if cells.len() != needed {
            return Err(Error::LengthMismatch {
                needed,
                given: cells.len(),
            });
        }
        self.fill(cells, &decision);
        Ok(())
    }

    pub(crate) fn fill<M: MassCell>(&mut self, cells: &[M], decision: &Decision<M>) {
        let rows = cells.chunks_exact(self.width.max(1) as usize);
        let words = self.words.chunks_exact_mut(words_per_row(self.width).max(1));
        for (row, words) in rows.zip(words) {
            for (cells, word) in row.chunks(32).zip(words) {
                let mut bits = 0;
                for (i, cell) in cells.iter().enumerate() {
                    bits |= u32::from(decision.is_occupied(*cell)) << i;
                }
                *word = bits;
            }
        }
    }

    pub(crate) fn set(&mut self, gx: u32, gy: u32, occupied: bool) {
        let at = self.word(gx, gy);
        if gx < self.width
            && let Some(word) = self.words.get_mut(at)
        {
            let bit = 1 << (gx % 32);
            *word = if occupied { *word | bit } else { *word & !bit };
        }
    }

    fn word(&self, gx: u32, gy: u32) -> usize {
        gy as usize * words_per_row(self.width) + gx as usize / 32
    }
}

/// Thresholds in the numbers of a cell type.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Decision<M> {
    free: u32,
    occupied: u32,
    otherwise: bool,
    cell: core::marker::PhantomData<M>,
}

impl<M: MassCell> Decision<M> {
    pub(crate) fn new(thresholds: BinaryThresholds) -> Result<Self, Error> {
        thresholds.validate()?;
        // No threshold above zero is met by a cell that says nothing.
        let steps = |threshold: f32| M::steps(threshold).max(u32::from(threshold > 0.0));
        Ok(Self {
            free: steps(thresholds.free_threshold),
            occupied: steps(thresholds.occupied_threshold),
            otherwise: !thresholds.is_optimistic,
            cell: core::marker::PhantomData,
        })
    }

    #[inline]
    pub(crate) fn is_occupied(&self, cell: M) -> bool {
        let (free, occupied) = cell.in_steps();
        occupied >= self.occupied || (free < self.free && self.otherwise)
    }
}
