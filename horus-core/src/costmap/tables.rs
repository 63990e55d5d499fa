use super::field::{FieldCell, InflatedCosts};
use super::kernel::stamp::DiscRows;
use super::kernel::{Disc, PREFER_LANES};
use super::params::Decay;
use super::words;
use super::{CellValue, CostParams};
use crate::error::Error;

/// Room for what follows from the parameters and the resolution; a cost map fills it once, so that
/// updates are integers only. 1.6 KiB for a one-byte field, 1.3 KiB for a two-byte one, on a
/// 32-bit target.
#[derive(Clone, Copy, Debug)]
pub struct CostTables<F: FieldCell> {
    /// Base cost of every cell value, read as a byte.
    base: [u8; 256],
    inflated: F::Costs,
    /// Inflated costs from here on overwrite an unknown cell; 256: none does.
    overwrites_unknown: u16,
    /// Unknown cells are sources; if not, one at distance 0 has just come into view.
    unknown_inflates: bool,
    /// Bytes of cell values that are sources: `byte - source_from <= source_span`, wrapping.
    source_from: u8,
    source_span: u8,
    pub(crate) disc: Disc,
    pub(crate) rows: DiscRows<F>,
}

impl<F: FieldCell> CostTables<F> {
    /// All bits zero: to be filled when a cost map is made.
    pub const EMPTY: Self = Self {
        base: [0; 256],
        inflated: F::Costs::EMPTY,
        overwrites_unknown: 0,
        unknown_inflates: false,
        source_from: 0,
        source_span: 0,
        disc: Disc { reach: 0, radius: 0 },
        rows: DiscRows::EMPTY,
    };

    /// How far costs above zero reach.
    ///
    /// # Errors
    /// [`Error::RadiusTooLarge`] if that is farther than the field's cells can hold.
    ///
    /// Complexity: one evaluation of the cost per squared distance within reach.
    pub(crate) fn reach(params: &CostParams, resolution: f32) -> Result<Disc, Error> {
        let limit = (F::MAX_RADIUS + 1) * (F::MAX_RADIUS + 1);
        let end = (1..=limit).find(|&squared| params.inflated_cost(squared, resolution) == 0);
        match end {
            // The two highest field values are no distances, and no sum of two squares either.
            Some(end) => Ok(Disc::new((end - 1).min(F::STALE.squared() - 1))),
            None => Err(Error::RadiusTooLarge {
                max_cells: F::MAX_RADIUS,
            }),
        }
    }

    pub(crate) fn fill(&mut self, params: &CostParams, resolution: f32, disc: Disc) {
        self.disc = disc;
        self.rows.fill(disc);
        self.inflated
            .fill(disc.reach, |squared| params.inflated_cost(squared, resolution));
        for (byte, base) in self.base.iter_mut().enumerate() {
            *base = params.base_cost(byte as u8 as i8);
        }
        self.overwrites_unknown = match (params.decay, params.inflate_unknown) {
            (Decay::Polynomial, _) => 256,
            (Decay::Exponential, false) => 253,
            (Decay::Exponential, true) => 1,
        };
        self.unknown_inflates = params.unknown_inflates;
        // Known values are the bytes 0..=127, unknown ones 128..=255.
        self.source_from = params.lethal_threshold as u8;
        self.source_span = if params.unknown_inflates { 255 } else { 127 } - self.source_from;
    }

    /// Reads cell bytes as base costs: 254 is the source, 255 unknown.
    #[cfg(test)]
    pub(crate) fn read_base_costs(&mut self, unknown_inflates: bool) {
        for (byte, base) in self.base.iter_mut().enumerate() {
            *base = byte as u8;
        }
        self.unknown_inflates = unknown_inflates;
        self.source_from = 254;
        self.source_span = u8::from(unknown_inflates);
    }

    /// True if a cell of this value is a source of inflation.
    #[inline]
    pub(crate) fn is_source(&self, value: u8) -> bool {
        value.wrapping_sub(self.source_from) <= self.source_span
    }

    /// [`is_source`](Self::is_source) for up to 32 cells, a bit each.
    #[inline]
    pub(crate) fn source_bits<V: CellValue>(&self, values: &[V]) -> u32 {
        let mut bits = 0;
        if PREFER_LANES {
            let mut flags = [0u8; 32];
            match values.first_chunk::<32>() {
                Some(values) => flags = values.map(|value| u8::from(self.is_source(value.byte()))),
                None => {
                    for (flag, value) in flags.iter_mut().zip(values) {
                        *flag = u8::from(self.is_source(value.byte()));
                    }
                }
            }
            for (i, eight) in flags.as_chunks::<8>().0.iter().enumerate() {
                // One byte, 0 or 1, per cell: the product gathers them in its highest eight bits.
                let gathered = u64::from_le_bytes(*eight).wrapping_mul(0x0102_0408_1020_4080) >> 56;
                bits |= (gathered as u32) << (8 * i);
            }
            return bits;
        }
        let (words, rest) = values.as_chunks();
        for (i, cells) in words.iter().enumerate() {
            let cells = cells.map(V::byte);
            bits |= words::within(cells, self.source_from, self.source_span) << (4 * i);
        }
        for (i, value) in rest.iter().enumerate() {
            bits |= u32::from(self.is_source(value.byte())) << (4 * words.len() + i);
        }
        bits
    }

    /// Writes the cost of a cell; true if it was another.
    pub(crate) fn refresh<V: CellValue>(&self, cost: &mut u8, value: V, field: F) -> bool {
        let new = self.cost(value.byte(), field);
        core::mem::replace(cost, new) != new
    }

    /// The cost of a cell from its value and its field.
    #[inline]
    pub(crate) fn cost(&self, value: u8, field: F) -> u8 {
        let base = self.base[usize::from(value)];
        let inflated = self.inflated.cost(field.squared());
        if base != super::UNKNOWN_COST {
            base.max(inflated)
        } else if u16::from(inflated) >= self.overwrites_unknown
            && (field != F::ZERO || self.unknown_inflates)
        {
            inflated
        } else {
            base
        }
    }
}
