use super::super::lattice::Centers;
use super::super::viewpoint::Viewpoint;
use super::super::{Lattice, MassCell};
use super::beams::Beams;
use super::{BeamLimits, Flatscan, ScanClass, SensorModel};
use crate::error::{Buffer, Error, require};
use crate::geometry::Pose2D;

/// The projection of one scan into a lattice, line by line along x.
pub(super) struct Projection<'a> {
    beams: Beams<'a>,
    centers: Centers,
    viewpoint: Viewpoint,
    rows: u32,
}

impl<'a> Projection<'a> {
    /// Checks everything.
    pub(super) fn new(
        scan: &Flatscan<'a>,
        sensor: Pose2D,
        lattice: &Lattice,
        model: &SensorModel,
        limits: &'a mut [BeamLimits],
    ) -> Result<Self, Error> {
        lattice.validate()?;
        if !sensor.is_finite() {
            return Err(Error::NonFinitePose);
        }
        Ok(Self {
            beams: Beams::new(scan, model, limits)?,
            centers: lattice.centers(),
            viewpoint: Viewpoint::new(sensor),
            rows: lattice.rows,
        })
    }

    /// Shows the classes of a column's cells, from row 0 on.
    #[inline]
    pub(super) fn line(&self, col: u32, mut show: impl FnMut(ScanClass)) {
        let (mut row, col) = (0.5, col as f32 + 0.5);
        for _ in 0..self.rows {
            let (x, y) = self.viewpoint.see(self.centers.at_halves(row, col));
            row += 1.0;
            let d2 = x * x + y * y;
            show(if d2 < self.beams.reach {
                self.beams.class(x, y, d2)
            } else {
                ScanClass::Vacuous
            });
        }
    }
}

/// Turns a scan into an evidence grid: what the sensor, which stands at `sensor` in the frame of the
/// lattice (metres, radians; its mounting pose, for a lattice around the robot), says about each cell.
///
/// Each cell asks the beam nearest to it in angle: before the hit it is `m_free`, from the hit to
/// `wall_thickness` behind it `m_occ`, behind that vacuous. A beam reaches half way to its
/// neighbours; beams that close a circle are neighbours, too. Cells that no beam covers, and those of
/// beams without a usable range, are vacuous. All in f32, in the order that
/// `horus_host::reference` writes out, so that no cell may differ.
///
/// # Errors
/// As [`Flatscan::validate`] and [`SensorModel::validate`]; [`Error::InvalidScan`] for a single beam
/// without `beam_half_width`; [`Error::NonFinitePose`]; as [`Lattice::validate`];
/// [`Error::BufferTooSmall`] if there are fewer `limits` than beams, or fewer cells than the lattice
/// has. Nothing has changed then.
///
/// # Complexity
/// One write per cell; one arc tangent per cell within reach of some beam, and a walk over the beams
/// between one cell and the next.
pub fn scan_to_evidence<M: MassCell>(
    scan: &Flatscan<'_>,
    sensor: Pose2D,
    lattice: &Lattice,
    model: &SensorModel,
    limits: &mut [BeamLimits],
    cells: &mut [M],
) -> Result<(), Error> {
    let projection = Projection::new(scan, sensor, lattice, model, limits)?;
    require(Buffer::Cells, lattice.cells(), cells.len())?;
    let masses = [ScanClass::Vacuous, ScanClass::Free, ScanClass::Occupied]
        .map(|class| M::from_masses(class.masses(model)));
    let mut cells = cells.iter_mut();
    for col in 0..lattice.cols {
        projection.line(col, |class| {
            if let Some(cell) = cells.next() {
                *cell = masses.get(class as usize).copied().unwrap_or_default();
            }
        });
    }
    Ok(())
}
