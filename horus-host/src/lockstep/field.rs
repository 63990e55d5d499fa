use horus_core::costmap::{CostTables, FieldCell, scratch_words};
use horus_core::prelude::{CostBuffers, CostMap, Error, OccupancyGrid, Pose2D};

use super::{LockstepConfig, LockstepError};

/// The core's distance field cell, one or two bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FieldWidth {
    /// `u8`: costs reach up to 15 cells.
    One,
    /// `u16`: costs reach up to 255 cells.
    Two,
}

impl FieldWidth {
    /// The narrowest field that holds the parameters at this resolution, and how many cells their
    /// costs above zero reach.
    ///
    /// # Errors
    /// [`LockstepError::Radius`] if even two bytes do not hold them; [`LockstepError::Core`].
    pub fn of(config: &LockstepConfig) -> Result<(Self, u32), LockstepError> {
        match effective_radius::<u8>(config) {
            Ok(radius) => return Ok((Self::One, radius)),
            Err(Error::RadiusTooLarge { .. }) => {}
            Err(error) => return Err(error.into()),
        }
        match effective_radius::<u16>(config) {
            Ok(radius) => Ok((Self::Two, radius)),
            Err(Error::RadiusTooLarge { max_cells }) => Err(LockstepError::Radius {
                radius: config.params.inflation_radius,
                resolution: config.resolution,
                max_cells,
            }),
            Err(error) => Err(error.into()),
        }
    }

    /// The Rust type's name: `u8` or `u16`.
    pub fn name(self) -> &'static str {
        match self {
            Self::One => "u8",
            Self::Two => "u16",
        }
    }
}

/// The reach of the costs in cells, from a cost map without cells.
fn effective_radius<F: FieldCell>(config: &LockstepConfig) -> Result<u32, Error> {
    let grid = OccupancyGrid::new_in(&mut [][..], 0, 0, config.resolution, Pose2D::default())?;
    let mut tables = CostTables::<F>::EMPTY;
    let buffers = CostBuffers {
        bits: &mut [],
        field: &mut [],
        scratch: &mut vec![0; most_scratch()],
        costs: None,
        tables: &mut tables,
    };
    Ok(CostMap::new_in(grid, buffers, config.params)?.effective_radius())
}

/// Scratch words that serve any radius.
fn most_scratch() -> usize {
    (0..=u16::MAX_RADIUS).map(scratch_words).max().unwrap_or(0)
}
