use super::CostParams;
use super::field::{FieldCell, InflatedCosts};
use super::kernel::Disc;
use super::params::Decay;
use crate::error::Error;

/// Everything that follows from the parameters and the resolution: computed once, so that
/// updates are integers only.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct CostTables<F: FieldCell> {
    /// Base cost of every cell value, read as a byte.
    base: [u8; 256],
    inflated: F::Costs,
    /// Inflated costs from here on overwrite an unknown cell; 256: none does.
    overwrites_unknown: u16,
    /// Bytes of cell values that are sources: `byte - source_from <= source_span`, wrapping.
    source_from: u8,
    source_span: u8,
    pub(crate) disc: Disc,
}

impl<F: FieldCell> CostTables<F> {
    pub(crate) const EMPTY: Self = Self {
        base: [0; 256],
        inflated: F::Costs::EMPTY,
        overwrites_unknown: 0,
        source_from: 0,
        source_span: 0,
        disc: Disc { reach: 0, radius: 0 },
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
            Some(end) => Ok(Disc::new(end - 1)),
            None => Err(Error::RadiusTooLarge {
                max_cells: F::MAX_RADIUS,
            }),
        }
    }

    pub(crate) fn fill(&mut self, params: &CostParams, resolution: f32, disc: Disc) {
        self.disc = disc;
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
        self.source_from = 254;
        self.source_span = u8::from(unknown_inflates);
    }

    /// True if a cell of this value is a source of inflation.
    #[inline]
    pub(crate) fn is_source(&self, value: u8) -> bool {
        value.wrapping_sub(self.source_from) <= self.source_span
    }

    /// The cost of a cell from its value and its field.
    #[inline]
    pub(crate) fn cost(&self, value: u8, field: F) -> u8 {
        let base = self.base[usize::from(value)];
        let inflated = self.inflated.cost(field.squared());
        if base != super::UNKNOWN_COST {
            base.max(inflated)
        } else if u16::from(inflated) >= self.overwrites_unknown {
            inflated
        } else {
            base
        }
    }
}
