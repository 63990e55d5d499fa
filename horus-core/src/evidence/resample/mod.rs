//! Evidence grids seen through other lattices, by bilinear interpolation.

mod rigid;
mod sampler;
mod walk;

pub(super) use self::rigid::{Rigid, frame_from_window};
pub(super) use self::sampler::{CellSampler, ClassSampler, Sampler};
pub(super) use self::walk::CellWalk;

use super::{Lattice, MassCell};
use crate::error::{Buffer, Error, require};
use crate::geometry::Pose2D;

/// Interpolates an evidence grid at the cell centres of another lattice: `src_from_dst` takes points
/// of the destination's frame into the source's (metres, radians).
///
/// Each cell is the mean of the four source cells around its centre, weighted bilinearly; cells
/// outside the source count as vacuous. A coordinate nearer than 1e-4 of a cell to a cell's centre
/// counts as there, so that aligned lattices copy.
///
/// # Errors
/// As [`Lattice::validate`]; [`Error::NonFinitePose`]; [`Error::BufferTooSmall`] for slices shorter
/// than their lattices. Nothing has changed then.
///
/// # Complexity
/// At most four reads and one write per destination cell.
pub fn resample<M: MassCell>(
    src: &[M],
    src_lattice: &Lattice,
    dst: &mut [M],
    dst_lattice: &Lattice,
    src_from_dst: Pose2D,
) -> Result<(), Error> {
    src_lattice.validate()?;
    dst_lattice.validate()?;
    if !src_from_dst.is_finite() {
        return Err(Error::NonFinitePose);
    }
    require(Buffer::Cells, src_lattice.cells(), src.len())?;
    require(Buffer::Cells, dst_lattice.cells(), dst.len())?;
    let dst = dst.get_mut(..dst_lattice.cells()).unwrap_or_default();
    let frames = Rigid::from(src_from_dst).after(&Rigid::from(dst_lattice.pose));
    let windows = Rigid::from(src_lattice.pose).inverse().after(&frames);
    let (rows, cols) = (dst_lattice.rows, dst_lattice.cols);
    let Some(mut walk) = CellWalk::new(
        &windows,
        (dst_lattice.cell_size, [rows, cols]),
        src_lattice.cell_size,
    ) else {
        dst.fill(M::VACUOUS);
        return Ok(());
    };
    let sampler = CellSampler {
        cells: src,
        lattice: src_lattice,
    };
    for line in dst.chunks_exact_mut(rows.max(1) as usize) {
        let mut places = walk;
        for cell in line {
            *cell = sampler.sample(places.next()).unwrap_or_default();
        }
        walk.next_line();
    }
    Ok(())
}
