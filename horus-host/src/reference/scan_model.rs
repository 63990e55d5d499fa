use super::ReferenceError;

/// How a scan changes the cells its beams cleared or hit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum ScanModel {
    /// Hit cells become 100, other cleared cells 0.
    #[default]
    Set,
    /// Every hit cell takes one hit step, every other cleared cell one miss step, however many beams met it.
    ///
    /// An unknown cell starts at 50. Legal are hit >= 0, miss <= 0 and 0 <= min <= max <= 100.
    Accumulate {
        /// Added to a hit cell.
        hit: i8,
        /// Added to a cleared cell: zero or negative.
        miss: i8,
        /// No cell the scan touches is left below this.
        min: i8,
        /// No cell the scan touches is left above this.
        max: i8,
    },
}

impl ScanModel {
    /// The accumulating model with its default steps: hit +20, miss -7, between 0 and 100.
    pub const fn accumulate() -> Self {
        Self::Accumulate {
            hit: 20,
            miss: -7,
            min: 0,
            max: 100,
        }
    }

    pub(super) fn validate(self) -> Result<(), ReferenceError> {
        match self {
            Self::Accumulate { hit, miss, min, max }
                if !(hit >= 0 && miss <= 0 && 0 <= min && min <= max && max <= 100) =>
            {
                Err(ReferenceError::ScanModel { hit, miss, min, max })
            }
            _ => Ok(()),
        }
    }

    /// The value after a scan that hit the cell, or only cleared it.
    pub(super) fn apply(self, value: i8, was_hit: bool) -> i8 {
        match self {
            Self::Set => 100 * i8::from(was_hit),
            Self::Accumulate { hit, miss, min, max } => {
                let start = if value < 0 { 50 } else { i32::from(value) };
                let step = i32::from(if was_hit { hit } else { miss });
                (start + step).clamp(i32::from(min), i32::from(max)) as i8
            }
        }
    }
}
