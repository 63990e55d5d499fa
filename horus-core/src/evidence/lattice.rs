use super::viewpoint::Viewpoint;
use crate::error::{Error, Parameter};
use crate::geometry::{GridInfo, Pose2D};

/// Where the cells of an evidence grid lie: Isaac's lattice.
///
/// Rows run along the lattice's x axis, columns along its y axis. In the words of the other grids
/// rows are the `width` and columns the `height`, row `r` is `gx`, column `c` is `gy`, and cells are
/// stored as there, x fastest: [`index`](Self::index) = c * rows + r.
///
/// The centre of cell (r, c) lies at pose * ((r + 0.5) * cell_size, (c + 0.5) * cell_size) in the
/// frame; [`new`](Self::new) sets the pose to cell_size * relative_offset * (rows, cols), without
/// rotation.
///
/// ```
/// use horus_core::evidence::Lattice;
///
/// let lattice = Lattice::default(); // ahead of the robot, half to its left and half to its right
/// assert_eq!((lattice.rows, lattice.cols), (256, 256));
/// assert_eq!((lattice.pose.x, lattice.pose.y), (0.0, -6.4));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Lattice {
    /// Cells along x.
    pub rows: u32,
    /// Cells along y.
    pub cols: u32,
    /// Metres per cell.
    pub cell_size: f32,
    /// Where the corner of cell (0, 0) lies relative to the frame's origin, in shares of the
    /// lattice: (0, -0.5) is ahead of it, (-0.5, -0.5) around it.
    pub relative_offset: [f32; 2],
    /// Name of the frame the pose is in.
    pub frame: &'static str,
    /// Pose of the corner of cell (0, 0) in the frame, metres and radians.
    pub pose: Pose2D,
}

impl Default for Lattice {
    /// Isaac's defaults: 256 x 256 cells of 0.05 m with offset (0, -0.5), in the frame `robot`.
    fn default() -> Self {
        Self::at_offset(256, 256, 0.05, [0.0, -0.5], "robot")
    }
}

impl Lattice {
    /// A lattice whose pose follows from its relative offset.
    ///
    /// # Errors
    /// As [`validate`](Self::validate).
    pub fn new(
        rows: u32,
        cols: u32,
        cell_size: f32,
        relative_offset: [f32; 2],
        frame: &'static str,
    ) -> Result<Self, Error> {
        let lattice = Self::at_offset(rows, cols, cell_size, relative_offset, frame);
        lattice.validate()?;
        Ok(lattice)
    }

    fn at_offset(
        rows: u32,
        cols: u32,
        cell_size: f32,
        relative_offset: [f32; 2],
        frame: &'static str,
    ) -> Self {
        let along = |offset: f32, cells: u32| cell_size * offset * cells as f32;
        let [x, y] = relative_offset;
        Self {
            rows,
            cols,
            cell_size,
            relative_offset,
            frame,
            pose: Pose2D::new(along(x, rows), along(y, cols), 0.0),
        }
    }

    /// Checks the numbers.
    ///
    /// # Errors
    /// [`Error::InvalidResolution`], [`Error::NonFinitePose`], [`Error::SizeOverflow`];
    /// [`Error::InvalidParameter`] for an offset that is not finite.
    pub fn validate(&self) -> Result<(), Error> {
        if !self.relative_offset.iter().all(|offset| offset.is_finite()) {
            return Err(Error::InvalidParameter(Parameter::RelativeOffset));
        }
        self.info().map(|_| ())
    }

    /// The same as size, resolution and place of a grid.
    ///
    /// # Errors
    /// [`Error::InvalidResolution`], [`Error::NonFinitePose`], [`Error::SizeOverflow`].
    pub fn info(&self) -> Result<GridInfo, Error> {
        GridInfo::new(self.rows, self.cols, self.cell_size, self.pose)
    }

    /// Number of cells.
    pub const fn cells(&self) -> usize {
        self.rows as usize * self.cols as usize
    }

    /// Index of a cell, `None` outside.
    pub const fn index(&self, row: u32, col: u32) -> Option<usize> {
        if row < self.rows && col < self.cols {
            Some(col as usize * self.rows as usize + row as usize)
        } else {
            None
        }
    }

    /// The centre of a cell in the frame, metres; also outside the lattice.
    pub fn center(&self, row: u32, col: u32) -> (f32, f32) {
        self.centers().at(row, col)
    }

    pub(super) fn centers(&self) -> Centers {
        Centers {
            pose: Viewpoint::new(self.pose),
            cell: self.cell_size,
        }
    }
}

/// Computes cell centres.
#[derive(Clone, Copy, Debug)]
pub(super) struct Centers {
    pose: Viewpoint,
    cell: f32,
}

impl Centers {
    #[inline]
    pub(super) fn at(&self, row: u32, col: u32) -> (f32, f32) {
        self.at_halves(row as f32 + 0.5, col as f32 + 0.5)
    }

    /// The same from row and column plus a half: whole numbers of halves, which are exact.
    #[inline]
    pub(super) fn at_halves(&self, row: f32, col: f32) -> (f32, f32) {
        self.pose.point((row * self.cell, col * self.cell))
    }
}
