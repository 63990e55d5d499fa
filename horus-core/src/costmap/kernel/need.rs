use super::super::field::FieldCell;
use super::low_bits;

/// Which cells of a row of up to 32 must be recomputed: those whose field lies between `from`,
/// lane by lane, and `to`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Need<F> {
    pub from: [F; 32],
    pub to: F,
}

impl<F: FieldCell> Need<F> {
    /// Every cell.
    pub(crate) fn all() -> Self {
        Self {
            from: [F::ZERO; 32],
            to: F::NONE,
        }
    }

    /// The cells marked stale.
    pub(crate) fn stale() -> Self {
        Self {
            from: [F::STALE; 32],
            to: F::STALE,
        }
    }

    /// The cells that have a source in reach, at least as far away as the lane says.
    pub(crate) fn at_least(from: [F; 32]) -> Self {
        Self { from, to: F::STALE }
    }

    pub(crate) fn is_all(&self) -> bool {
        self.to == F::NONE
    }

    fn is_stale(&self) -> bool {
        // Lanes of the third kind are squares or NONE; STALE (254, 65534) is no square.
        self.from[0] == F::STALE
    }

    #[inline]
    pub(crate) fn lane(&self, field: F, from: F) -> bool {
        from <= field && field <= self.to
    }

    /// The cells of a row as bits.
    #[inline]
    pub(crate) fn mask(&self, row: &[F]) -> u32 {
        if self.is_all() {
            return low_bits(row.len() as u32);
        }
        if self.is_stale() {
            return F::stale_bits(row);
        }
        let mut mask = 0;
        for (lane, (&field, &from)) in row.iter().zip(&self.from).enumerate() {
            mask |= u32::from(self.lane(field, from)) << lane;
        }
        mask
    }
}
