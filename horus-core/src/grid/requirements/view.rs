use nalgebra::{Isometry2, Vector2};

use super::{DenseGrid2, LinearGrid2, OccupancyGrid2d, RegularGrid, ValueTraits};
use crate::error::{Buffer, Error, require};
use crate::geometry::{GridInfo, Pose2D};

/// A borrowed, read-only grid whose values mean what `V` says: a prior map in flash, another library's buffer.
///
/// Row-major, row 0 has the lowest y, the corner of cell (0, 0) lies at the origin.
///
/// # Examples
/// ```
/// use horus_core::grid::{GridView, LocalMapValues, OccupancyGrid2d};
/// use horus_core::prelude::*;
///
/// let cells = [255, 0, 128, 255];
/// let map = GridView::new(&cells, 2, 2, 0.1, Pose2D::new(0.0, 0.0, 0.0), LocalMapValues)?;
/// assert_eq!(map.free_cells().collect::<Vec<_>>(), [0, 3]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct GridView<'a, V: ValueTraits> {
    info: GridInfo,
    /// One per cell.
    data: &'a [V::Value],
    values: V,
}

impl<'a, V: ValueTraits> GridView<'a, V> {
    /// A view of `width` x `height` cells of `resolution` metres; `cells` may be longer.
    ///
    /// # Errors
    /// [`Error::InvalidResolution`], [`Error::NonFinitePose`], [`Error::SizeOverflow`];
    /// [`Error::BufferTooSmall`] if `cells` is shorter than `width * height`.
    pub fn new(
        cells: &'a [V::Value],
        width: u32,
        height: u32,
        resolution: f32,
        origin: Pose2D,
        values: V,
    ) -> Result<Self, Error> {
        Self::with_info(GridInfo::new(width, height, resolution, origin)?, cells, values)
    }

    /// A view of cells that lie where `info` says.
    ///
    /// # Errors
    /// [`Error::BufferTooSmall`] if `cells` is shorter than the grid.
    pub fn with_info(info: GridInfo, cells: &'a [V::Value], values: V) -> Result<Self, Error> {
        require(Buffer::Cells, info.cells(), cells.len())?;
        let data = cells.get(..info.cells()).unwrap_or_default();
        Ok(Self { info, data, values })
    }

    /// Size, resolution and place.
    pub const fn info(&self) -> &GridInfo {
        &self.info
    }
}

impl<V: ValueTraits> RegularGrid for GridView<'_, V> {
    fn resolution(&self) -> f32 {
        self.info.resolution()
    }
}

impl<V: ValueTraits> DenseGrid2 for GridView<'_, V> {
    type Data = V::Value;

    fn width(&self) -> u32 {
        self.info.width()
    }

    fn height(&self) -> u32 {
        self.info.height()
    }

    #[inline]
    fn value(&self, cell: Vector2<i32>) -> Option<V::Value> {
        self.data.get(self.index_at(cell)?).copied()
    }
}

impl<V: ValueTraits> LinearGrid2 for GridView<'_, V> {
    #[inline]
    fn data(&self) -> &[V::Value] {
        self.data
    }
}

impl<V: ValueTraits> OccupancyGrid2d for GridView<'_, V> {
    type Values = V;

    #[inline]
    fn value_traits(&self) -> V {
        self.values
    }

    fn origin(&self) -> Isometry2<f32> {
        self.info.isometry()
    }
}
