use horus_core::distance::{DistanceBuffers, DistanceMap, DistanceOptions, EnvelopeVertex};
use horus_core::prelude::{OccupancyGrid, Pose2D};
use horus_host::lockstep::{FixedMap, LockstepConfig, LockstepError};
use indicatif::ProgressBar;

/// How distances are computed.
#[derive(Debug, Clone, Copy)]
pub struct Distances {
    /// Metres beyond which they are not told apart.
    pub longest: Option<f32>,
    pub options: DistanceOptions,
}

/// Rows between two steps of the bar.
const STEP: u32 = 64;

impl Distances {
    /// Computes the distance of every cell in metres, row-major, and hands it to `take`. Four bytes per
    /// cell.
    ///
    /// # Errors
    /// A side that is too long, or memory that is short.
    pub fn compute<T>(
        &self,
        config: &LockstepConfig,
        origin: Pose2D,
        map: &FixedMap<'_>,
        bar: &ProgressBar,
        take: impl FnOnce(&DistanceMap<'_, u32>) -> T,
    ) -> anyhow::Result<T> {
        let LockstepConfig {
            width,
            height,
            resolution,
            ..
        } = *config;
        let grid = OccupancyGrid::view(map.occupancy(), width, height, resolution, origin)?;
        let mut cells = Vec::new();
        cells
            .try_reserve_exact(config.cells())
            .map_err(|_| LockstepError::Memory { width, height })?;
        cells.resize(config.cells(), 0);
        let mut vertices = vec![EnvelopeVertex::EMPTY; width as usize];
        let mut distances = DistanceMap::new_in(DistanceBuffers {
            cells: &mut cells,
            vertices: &mut vertices,
        });
        let options = match self.longest {
            Some(metres) => self.options.with_max_distance(metres, resolution),
            None => self.options,
        };
        distances.begin(&grid, options)?;
        while distances.advance(STEP) > 0 {
            bar.inc((STEP / 2).into()); // two sweeps
        }
        Ok(take(&distances))
    }
}
