use nalgebra::{Isometry2, Translation2, UnitComplex};

use super::{CELL_LIMIT, Pose2D};
use crate::error::Error;
use crate::math;

/// Added to a coordinate in cells before flooring, so that a point on a nominal cell boundary
/// belongs to the upper cell however its decimal numbers rounded.
const BOUNDARY_EPSILON: f32 = 1.0 / 1024.0;

/// Size, resolution and place of a grid: what `nav_msgs` calls `info`.
///
/// Row-major, `index = gy * width + gx`, row 0 has the lowest y. The corner of cell (0, 0), not
/// its centre, lies at [`origin`](Self::origin); `theta` of the origin is applied. The window of
/// a rolling grid lies a whole number of cells, [`offset`](Self::offset), from the pose given at
/// construction, so nothing accumulates however far it moves.
///
/// All bits zero is a legal 0 x 0 grid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GridInfo {
    resolution: f32,
    width: u32,
    height: u32,
    origin0: Pose2D,
    cos: f32,
    sin: f32,
    offset: [i32; 2],
}

impl GridInfo {
    /// The all-zero 0 x 0 grid: every point is outside.
    pub const EMPTY: Self = Self {
        resolution: 0.0,
        width: 0,
        height: 0,
        origin0: Pose2D::new(0.0, 0.0, 0.0),
        cos: 0.0,
        sin: 0.0,
        offset: [0; 2],
    };

    /// A grid of `width * height` cells of `resolution` metres whose first corner is at `origin`
    /// in the world frame.
    ///
    /// # Errors
    /// [`Error::InvalidResolution`], [`Error::NonFinitePose`]; [`Error::SizeOverflow`] if a side
    /// exceeds 2^30, or the cells are 2^32 - 1 or more, or too many for the address space.
    pub fn new(width: u32, height: u32, resolution: f32, origin: Pose2D) -> Result<Self, Error> {
        if !(resolution.is_finite() && resolution > 0.0) {
            return Err(Error::InvalidResolution(resolution));
        }
        if !origin.is_finite() {
            return Err(Error::NonFinitePose);
        }
        let limit = CELL_LIMIT as u32;
        if width > limit || height > limit || checked_cells(width, height).is_none() {
            return Err(Error::SizeOverflow);
        }
        let (cos, sin) = math::cos_sin(origin.theta);
        Ok(Self {
            resolution,
            width,
            height,
            origin0: origin,
            cos,
            sin,
            offset: [0; 2],
        })
    }

    /// Metres per cell.
    pub const fn resolution(&self) -> f32 {
        self.resolution
    }

    /// Columns.
    pub const fn width(&self) -> u32 {
        self.width
    }

    /// Rows.
    pub const fn height(&self) -> u32 {
        self.height
    }

    /// Number of cells.
    pub const fn cells(&self) -> usize {
        self.width as usize * self.height as usize
    }

    /// Whole cells the window has moved along the grid's axes since construction.
    pub const fn offset(&self) -> [i32; 2] {
        self.offset
    }

    /// World pose of the corner of cell (0, 0), metres and radians; it moves with the window.
    pub fn origin(&self) -> Pose2D {
        let (x, y) = self.world(
            self.offset[0] as f32 * self.resolution,
            self.offset[1] as f32 * self.resolution,
        );
        Pose2D::new(x, y, self.origin0.theta)
    }

    /// The same pose as a nalgebra isometry, without computing its sine and cosine anew.
    pub fn isometry(&self) -> Isometry2<f32> {
        let corner = self.origin();
        Isometry2::from_parts(
            Translation2::new(corner.x, corner.y),
            UnitComplex::from_cos_sin_unchecked(self.cos, self.sin),
        )
    }

    /// World pose of the corner of cell (0, 0) as given at construction, metres and radians.
    pub const fn first_origin(&self) -> Pose2D {
        self.origin0
    }

    /// Index of a cell, `None` outside the grid.
    pub const fn index(&self, gx: u32, gy: u32) -> Option<usize> {
        if gx < self.width && gy < self.height {
            Some(gy as usize * self.width as usize + gx as usize)
        } else {
            None
        }
    }

    /// The cell that holds a world point (metres); outside the grid or not finite: `None`.
    #[inline]
    pub fn world_to_grid(&self, x: f32, y: f32) -> Option<(u32, u32)> {
        let (cx, cy) = self.world_to_cell(x, y)?;
        let (gx, gy) = (cx as u32, cy as u32); // a negative coordinate becomes too large
        (gx < self.width && gy < self.height).then_some((gx, gy))
    }

    /// World coordinates (metres) of a cell's centre; outside the grid: `None`.
    pub fn grid_to_world(&self, gx: u32, gy: u32) -> Option<(f32, f32)> {
        self.index(gx, gy)?;
        let centre = |g: u32, offset: i32| (offset as f32 + g as f32 + 0.5) * self.resolution;
        Some(self.world(centre(gx, self.offset[0]), centre(gy, self.offset[1])))
    }

    /// The cell of a world point in window coordinates, also outside the window.
    ///
    /// `None` for a point that is not finite or is more than 2^30 cells away.
    #[inline]
    pub fn world_to_cell(&self, x: f32, y: f32) -> Option<(i32, i32)> {
        let (lx, ly) = self.local(x, y);
        if !(lx.is_finite() && ly.is_finite()) {
            return None;
        }
        Some((self.cell(lx, 0)?, self.cell(ly, 1)?))
    }

    #[inline]
    fn cell(&self, local: f32, axis: usize) -> Option<i32> {
        let k = math::floor_i32(local / self.resolution + BOUNDARY_EPSILON);
        let cell = k.checked_sub(self.offset[axis])?;
        (-CELL_LIMIT..=CELL_LIMIT).contains(&cell).then_some(cell)
    }

    /// A world point in metres along the grid's axes, from the corner given at construction.
    #[inline]
    fn local(&self, x: f32, y: f32) -> (f32, f32) {
        let (dx, dy) = (x - self.origin0.x, y - self.origin0.y);
        (self.cos * dx + self.sin * dy, self.cos * dy - self.sin * dx)
    }

    fn world(&self, lx: f32, ly: f32) -> (f32, f32) {
        (
            self.origin0.x + (self.cos * lx - self.sin * ly),
            self.origin0.y + (self.sin * lx + self.cos * ly),
        )
    }

    /// A world point in continuous window coordinates (cells).
    pub(crate) fn world_to_continuous(&self, x: f32, y: f32) -> (f32, f32) {
        let (lx, ly) = self.local(x, y);
        (
            lx / self.resolution - self.offset[0] as f32,
            ly / self.resolution - self.offset[1] as f32,
        )
    }

    /// Whole cells by which the window must move to have `pose` at its centre; ties to even.
    ///
    /// # Errors
    /// [`Error::NonFinitePose`]; [`Error::OffsetOutOfRange`] beyond +-2^30 cells.
    pub fn shift_to(&self, pose: Pose2D) -> Result<[i32; 2], Error> {
        if !pose.is_finite() {
            return Err(Error::NonFinitePose);
        }
        if self.resolution == 0.0 {
            return Ok([0; 2]); // the all-zero grid
        }
        let (lx, ly) = self.local(pose.x, pose.y);
        let shift = |l: f32, offset: i32, size: u32| {
            let cells = math::rint(l / self.resolution - (offset as f32 + size as f32 * 0.5));
            // Also false for NaN: coordinates that overflowed.
            (cells.abs() < 2.0 * CELL_LIMIT as f32).then_some(cells as i32)
        };
        let along_x = shift(lx, self.offset[0], self.width);
        let along_y = shift(ly, self.offset[1], self.height);
        let shift = along_x.zip(along_y).map(|(dx, dy)| [dx, dy]);
        shift
            .filter(|shift| self.moved(*shift).is_some())
            .ok_or(Error::OffsetOutOfRange)
    }

    fn moved(&self, shift: [i32; 2]) -> Option<[i32; 2]> {
        let along = |axis: usize| {
            let offset = self.offset[axis].checked_add(shift[axis])?;
            (-CELL_LIMIT..=CELL_LIMIT).contains(&offset).then_some(offset)
        };
        Some([along(0)?, along(1)?])
    }

    /// Moves the window by a shift that [`shift_to`](Self::shift_to) returned.
    pub(crate) fn shift_by(&mut self, shift: [i32; 2]) {
        if let Some(offset) = self.moved(shift) {
            self.offset = offset;
        }
    }
}

/// The cell of a coordinate (metres) along one axis of a grid whose cell 0 starts at 0; `None` if it is
/// not finite or beyond the range of `i32`.
#[inline]
pub(crate) fn cell_along(local: f32, resolution: f32) -> Option<i32> {
    const LIMIT: f32 = 2_147_483_648.0;
    let cells = local / resolution + BOUNDARY_EPSILON;
    (-LIMIT..LIMIT).contains(&cells).then(|| math::floor_i32(cells))
}

/// `width * height` where a slice of that many cells can exist and a `u32` can index it.
fn checked_cells(width: u32, height: u32) -> Option<usize> {
    let cells = (width as usize).checked_mul(height as usize)?;
    (cells <= isize::MAX as usize && cells < u32::MAX as usize).then_some(cells)
}
