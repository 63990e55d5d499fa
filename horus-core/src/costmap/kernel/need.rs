use super::super::field::FieldCell;
use super::low_bits;

/// Which cells of a row of up to 32 must be recomputed.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Need<F> {
    /// Every cell.
    All,
    /// Those marked stale.
    Stale,
    /// Those that have a source in reach, at least as far away as the lane says.
    AtLeast(Lanes<F>),
}

/// A field value per cell of a row; aligned, so that it is copied a word at a time.
#[derive(Clone, Copy, Debug)]
#[repr(align(4))]
pub(crate) struct Lanes<F>(pub [F; 32]);

impl<F: FieldCell> Need<F> {
    /// Lane by lane the least field of a cell that must be recomputed, and the greatest of all lanes.
    #[inline]
    pub(crate) fn limits(&self) -> ([F; 32], F) {
        match *self {
            Self::All => ([F::ZERO; 32], F::NONE),
            Self::Stale => ([F::STALE; 32], F::STALE),
            // STALE is the greatest value below NONE.
            Self::AtLeast(Lanes(from)) => (from, F::STALE),
        }
    }

    /// The cells of a row as bits.
    #[inline]
    pub(crate) fn mask(&self, row: &[F]) -> u32 {
        match self {
            Self::All => low_bits(row.len() as u32),
            Self::Stale => F::stale_bits(row),
            Self::AtLeast(Lanes(from)) => {
                let mut mask = 0;
                for (lane, (&field, &from)) in row.iter().zip(from).enumerate() {
                    mask |= u32::from(from <= field && field != F::NONE) << lane;
                }
                mask
            }
        }
    }

    /// Whether the only cell of a row must be recomputed.
    #[inline]
    pub(crate) fn first(&self, field: F) -> bool {
        match *self {
            Self::All => true,
            Self::Stale => field == F::STALE,
            Self::AtLeast(Lanes([from, ..])) => from <= field && field != F::NONE,
        }
    }
}
