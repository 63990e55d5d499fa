use super::classes::Classes;
use super::project::Projection;
use super::{BeamLimits, Flatscan, ScanClass, SensorModel};
use crate::error::Error;
use crate::evidence::{Lattice, MassCell};
use crate::geometry::Pose2D;

/// The evidence grid of one sensor: what its last scan says about each cell of its lattice.
///
/// A scan knows only three kinds of cell, so two bits per cell hold it ([`class_bytes`](super::class_bytes)):
/// 4.4 kB for 128 x 128 cells.
///
/// ```
/// use horus_core::evidence::{BeamLimits, Flatscan, Lattice, ScanClass, SensorGrid, SensorModel, class_bytes};
/// use horus_core::prelude::Pose2D;
///
/// let mut bytes = [0; class_bytes(40, 40)];
/// let lattice = Lattice::new(40, 40, 0.05, [0.0, -0.5], "robot")?;
/// let mut grid = SensorGrid::new_in(&mut bytes, lattice, SensorModel::default())?;
///
/// let scan = Flatscan {
///     angles: &[-0.2, 0.0, 0.2],
///     ranges: &[1.0, 1.0, f32::NAN],
///     invalid_range_threshold: 0.05,
///     out_of_range_threshold: 8.0,
///     visibilities: None,
/// };
/// grid.project(&scan, Pose2D::default(), &mut [BeamLimits::EMPTY; 3])?;
/// assert_eq!(grid.class(10, 20), ScanClass::Free);
/// assert_eq!(grid.class(20, 20), ScanClass::Occupied);
/// assert_eq!(grid.class(30, 20), ScanClass::Vacuous);
/// # Ok::<(), horus_core::Error>(())
/// ```
#[derive(Debug)]
pub struct SensorGrid<'a> {
    lattice: Lattice,
    model: SensorModel,
    classes: Classes<'a>,
}

impl<'a> SensorGrid<'a> {
    /// A grid of vacuous cells over at least [`class_bytes`](super::class_bytes) bytes.
    ///
    /// # Errors
    /// As [`Lattice::validate`] and [`SensorModel::validate`]; [`Error::BufferTooSmall`].
    pub fn new_in(bytes: &'a mut [u8], lattice: Lattice, model: SensorModel) -> Result<Self, Error> {
        lattice.validate()?;
        model.validate()?;
        Ok(Self {
            lattice,
            model,
            classes: Classes::new_in(bytes, &lattice)?,
        })
    }

    /// Where the cells lie.
    pub const fn lattice(&self) -> &Lattice {
        &self.lattice
    }

    /// What the beams say.
    pub const fn model(&self) -> &SensorModel {
        &self.model
    }

    /// Takes a scan of a sensor that stands at `sensor` in the lattice's frame, by the rule of
    /// [`scan_to_evidence`](super::scan_to_evidence); what the grid held is forgotten.
    ///
    /// # Errors
    /// As there; the grid stays as it was.
    ///
    /// # Complexity
    /// As there.
    pub fn project(
        &mut self,
        scan: &Flatscan<'_>,
        sensor: Pose2D,
        limits: &mut [BeamLimits],
    ) -> Result<(), Error> {
        let projection = Projection::new(scan, sensor, &self.lattice, &self.model, limits)?;
        for col in 0..self.lattice.cols {
            let mut line = self.classes.line(col);
            projection.line(col, |class| line.push(class));
            line.finish();
        }
        Ok(())
    }

    pub(crate) fn quad(&self, row: i32, col: i32) -> u8 {
        self.classes.quad(row, col)
    }

    /// Makes every cell vacuous.
    pub fn clear(&mut self) {
        self.classes.clear();
    }

    /// What the last scan says about a cell; outside: vacuous.
    pub fn class(&self, row: u32, col: u32) -> ScanClass {
        self.classes.class(row, col)
    }

    /// The masses of a cell as a cell type holds them; outside: vacuous.
    pub fn cell<M: MassCell>(&self, row: u32, col: u32) -> M {
        M::from_masses(self.class(row, col).masses(&self.model))
    }
}
