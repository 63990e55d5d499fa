use super::fusion::PreparedRule;
use super::resample::{CellSampler, CellWalk, ClassSampler, Rigid, Sampler, frame_from_window};
use super::{EvidenceU16, FusionReport, FusionRule, Lattice, MassCell, Masses, SensorGrid, Tally};
use crate::error::{Buffer, Error, require};
use crate::geometry::{GridInfo, Pose2D};
use crate::storage;

/// Cells that are resampled before they are fused.
const CHUNK: usize = 32;

/// The fused evidence of all sensors over time: a world-aligned rolling window of mass cells that
/// moves by whole cells with the robot.
///
/// Cells are row-major as in every grid of this crate: `index = gy * width + gx`. Moving by whole
/// cells keeps what is known exactly; resampling the map at every tick would smear it.
///
/// Source: Isaac `EvidenceMapFusion`.
///
/// ```
/// use horus_core::evidence::{EvidenceFusion, EvidenceU16, FusionRule, Lattice};
/// use horus_core::prelude::Pose2D;
///
/// let mut cells = [EvidenceU16::default(); 64 * 64];
/// let lattice = Lattice::new(64, 64, 0.05, [-0.5, -0.5], "odom")?;
/// let mut map = EvidenceFusion::new_in(&mut cells, lattice, FusionRule::default())?;
/// assert_eq!(map.recenter(Pose2D::new(0.11, 0.0, 0.5))?, [2, 0]);
/// assert_eq!(map.masses_at(0, 0).map(|m| m.uncertain()), Some(1.0));
/// # Ok::<(), horus_core::Error>(())
/// ```
#[derive(Debug)]
pub struct EvidenceFusion<'a, M: MassCell = EvidenceU16> {
    info: GridInfo,
    cells: &'a mut [M],
    rule: FusionRule,
    prepared: PreparedRule,
}

impl<'a, M: MassCell> EvidenceFusion<'a, M> {
    /// A map of vacuous cells; the frame of the lattice is the world.
    ///
    /// # Errors
    /// As [`Lattice::validate`]; [`Error::InvalidParameter`] for an ignorance floor outside [0, 1);
    /// [`Error::UnsupportedFusion`] if the cell type cannot hold the rule's results;
    /// [`Error::BufferTooSmall`].
    ///
    /// # Complexity
    /// One write per cell.
    pub fn new_in(cells: &'a mut [M], lattice: Lattice, rule: FusionRule) -> Result<Self, Error> {
        lattice.validate()?;
        M::supports(rule)?;
        let prepared = PreparedRule::new(rule)?;
        let info = lattice.info()?;
        require(Buffer::Cells, info.cells(), cells.len())?;
        let cells = cells.get_mut(..info.cells()).unwrap_or_default();
        cells.fill(M::VACUOUS);
        Ok(Self {
            info,
            cells,
            rule,
            prepared,
        })
    }

    /// Size, resolution and place of the window.
    pub const fn info(&self) -> &GridInfo {
        &self.info
    }

    /// The rule in force.
    pub const fn rule(&self) -> FusionRule {
        self.rule
    }

    /// All cells, row-major.
    pub fn cells(&self) -> &[M] {
        self.cells
    }

    /// A cell; outside the window: `None`.
    pub fn cell_at(&self, gx: u32, gy: u32) -> Option<M> {
        self.cells.get(self.info.index(gx, gy)?).copied()
    }

    /// The masses of a cell; outside the window: `None`.
    pub fn masses_at(&self, gx: u32, gy: u32) -> Option<Masses> {
        self.cell_at(gx, gy).map(M::masses)
    }

    /// The masses at a world point (metres); outside the window, NaN or infinite: `None`.
    pub fn masses(&self, x: f32, y: f32) -> Option<Masses> {
        let (gx, gy) = self.info.world_to_grid(x, y)?;
        self.masses_at(gx, gy)
    }

    /// Makes every cell vacuous; the window stays where it is.
    pub fn clear(&mut self) {
        self.cells.fill(M::VACUOUS);
    }

    /// Replaces all cells, row-major; under a rule with an ignorance floor, each gets it.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`] unless there is one cell each; nothing changes then.
    pub fn load(&mut self, cells: &[M]) -> Result<(), Error> {
        if cells.len() != self.cells.len() {
            return Err(Error::LengthMismatch {
                needed: self.cells.len(),
                given: cells.len(),
            });
        }
        self.cells.copy_from_slice(cells);
        if self.prepared.vacuous_is_neutral() {
            for chunk in self.cells.chunks_mut(CHUNK) {
                M::fuse(&self.prepared, chunk, &[M::VACUOUS; CHUNK]);
            }
        }
        Ok(())
    }

    /// Moves the window by whole cells so that `robot` (world, metres) is nearest to its centre;
    /// returns the cells moved along x and y. Cells keep their masses, new ones are vacuous.
    ///
    /// # Errors
    /// [`Error::NonFinitePose`], [`Error::OffsetOutOfRange`]; nothing changes then.
    ///
    /// # Complexity
    /// One read and one write per cell, none for a zero shift.
    pub fn recenter(&mut self, robot: Pose2D) -> Result<[i32; 2], Error> {
        let shift = self.info.shift_to(robot)?;
        storage::shift_cells(
            self.cells,
            self.info.width(),
            self.info.height(),
            shift,
            M::VACUOUS,
        );
        self.info.shift_by(shift);
        Ok(shift)
    }

    /// Fuses what a sensor's last scan says. `world_from_frame` is the world pose of the frame of the
    /// sensor grid's lattice: the robot's pose, for a lattice around the robot.
    ///
    /// # Errors
    /// [`Error::NonFinitePose`]; nothing changes then.
    ///
    /// # Complexity
    /// One read of four neighbours per cell, and a fusion per cell that is not vacuous (under Josang's
    /// average: per cell).
    pub fn fuse(&mut self, sensor: &SensorGrid<'_>, world_from_frame: Pose2D) -> Result<FusionReport, Error> {
        self.tally(sensor, world_from_frame).map(Tally::report::<M>)
    }

    pub(super) fn tally(
        &mut self,
        sensor: &SensorGrid<'_>,
        world_from_frame: Pose2D,
    ) -> Result<Tally, Error> {
        self.fuse_sampled(&ClassSampler::new(sensor), sensor.lattice(), world_from_frame)
    }

    /// Fuses any evidence grid: `cells` over `lattice`, whose frame lies at `world_from_frame`.
    ///
    /// # Errors
    /// As [`Lattice::validate`]; [`Error::NonFinitePose`]; [`Error::BufferTooSmall`] for fewer cells
    /// than the lattice has. Nothing changes then.
    ///
    /// # Complexity
    /// As [`fuse`](Self::fuse).
    pub fn fuse_evidence(
        &mut self,
        cells: &[M],
        lattice: &Lattice,
        world_from_frame: Pose2D,
    ) -> Result<FusionReport, Error> {
        lattice.validate()?;
        require(Buffer::Cells, lattice.cells(), cells.len())?;
        self.fuse_sampled(&CellSampler { cells, lattice }, lattice, world_from_frame)
            .map(Tally::report::<M>)
    }

    fn fuse_sampled<S: Sampler<M>>(
        &mut self,
        sampler: &S,
        lattice: &Lattice,
        world_from_frame: Pose2D,
    ) -> Result<Tally, Error> {
        if !world_from_frame.is_finite() {
            return Err(Error::NonFinitePose);
        }
        let world_from_src = Rigid::from(world_from_frame).after(&Rigid::from(lattice.pose));
        let src_from_dst = world_from_src.inverse().after(&frame_from_window(&self.info));
        let size = [self.info.width(), self.info.height()];
        let walk = CellWalk::new(&src_from_dst, (self.info.resolution(), size), lattice.cell_size);
        let neutral = self.prepared.vacuous_is_neutral();
        let mut tally = Tally::default();
        let Some(mut walk) = walk else {
            if !neutral {
                for chunk in self.cells.chunks_mut(CHUNK) {
                    tally.add(M::fuse(&self.prepared, chunk, &[M::VACUOUS; CHUNK]));
                }
            }
            return Ok(tally);
        };
        for line in self.cells.chunks_exact_mut(size[0].max(1) as usize) {
            let mut places = walk;
            for chunk in line.chunks_mut(CHUNK) {
                let mut sensor = [M::VACUOUS; CHUNK];
                let mut is_vacuous = true;
                for (cell, _) in sensor.iter_mut().zip(chunk.iter()) {
                    if let Some(seen) = sampler.sample(places.next()) {
                        *cell = seen;
                        is_vacuous = false;
                    }
                }
                if !(neutral && is_vacuous) {
                    tally.add(M::fuse(&self.prepared, chunk, &sensor));
                }
            }
            walk.next_line();
        }
        Ok(tally)
    }
}
