use super::columns;
use super::rows::{Cap, Place, Rows};
use super::{DistanceBuffers, DistanceCell, DistanceOptions, MAX_SIDE};
use crate::error::{Buffer, Error, require};
use crate::geometry::CellRect;
use crate::grid::OccupancyGrid2d;
use crate::math;

/// Exact distances from the cells of a grid, or of a window of it, to the nearest obstacle.
///
/// Row-major like the grid. Cells hold squared distances in cells, `D` says how many bytes and whether they are
/// signed ([`DistanceCell`]). Obstacles are the grid's occupied cells and, if so asked, its unknown ones;
/// where there is none within the cap, a cell holds the cap. Nothing can be read before the first
/// computation has ended.
///
/// # Examples
/// ```
/// use horus_core::distance::{DistanceMap, DistanceMapBuffers, DistanceOptions};
/// use horus_core::prelude::*;
///
/// let mut cells = [0; 5 * 4];
/// let mut grid = OccupancyGrid::new_in(&mut cells[..], 5, 4, 0.5, Pose2D::new(0.0, 0.0, 0.0))?;
/// grid.set_occupancy(1, 1, 100);
/// let mut storage = DistanceMapBuffers::<u16, 20, 5>::empty();
/// let mut map = DistanceMap::new_in(storage.split());
/// map.compute(&grid, DistanceOptions::default())?;
/// assert_eq!(map.squared()[..5], [2, 1, 2, 5, 10]);
/// assert_eq!(map.metres_at(4, 1), Some(1.5));
/// assert_eq!(map.nearest_obstacle(&grid, 4, 3), Some((1, 1)));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug)]
pub struct DistanceMap<'a, D> {
    buffers: DistanceBuffers<'a, D>,
    resolution: f32,
    options: DistanceOptions,
    window: CellRect,
    /// Cells that `buffers.cells` holds while computing.
    region: CellRect,
    /// Rows that are still to be done: those of the sweep back through the columns, but for the last, then those
    /// of the envelopes.
    rows_left: u32,
    rows: Rows,
}

impl<'a, D: DistanceCell> DistanceMap<'a, D> {
    /// A map of nothing over its buffers.
    pub fn new_in(buffers: DistanceBuffers<'a, D>) -> Self {
        Self {
            buffers,
            resolution: 0.0,
            options: DistanceOptions::default(),
            window: NOTHING,
            region: NOTHING,
            rows_left: 0,
            rows: Rows::new(Cap(0)),
        }
    }

    /// Computes the distances of all cells of a grid.
    ///
    /// # Errors
    /// [`Error::SizeOverflow`] if a side of the grid exceeds [`MAX_SIDE`];
    /// [`Error::BufferTooSmall`]. The map stays as it was.
    ///
    /// # Complexity
    /// At most nine cell visits per cell.
    pub fn compute(&mut self, grid: &impl OccupancyGrid2d, options: DistanceOptions) -> Result<(), Error> {
        self.begin(grid, options)?;
        self.advance(u32::MAX);
        Ok(())
    }

    /// Computes the distances of the cells of a window; obstacles outside it count as well.
    ///
    /// # Errors
    /// As [`compute`](Self::compute), and [`Error::WindowOutside`] for a window that reaches out of the grid.
    ///
    /// # Complexity
    /// At most nine cell visits per cell of the [region](Self::region), and two per cell of it that lies within the
    /// cap above or below the window.
    pub fn compute_window(
        &mut self,
        grid: &impl OccupancyGrid2d,
        window: CellRect,
        options: DistanceOptions,
    ) -> Result<(), Error> {
        self.begin_window(grid, window, options)?;
        self.advance(u32::MAX);
        Ok(())
    }

    /// Starts computing: reads the grid, which may change afterwards, and leaves the rest to
    /// [`advance`](Self::advance).
    ///
    /// # Errors
    /// As [`compute`](Self::compute).
    ///
    /// # Complexity
    /// Two cell visits per cell.
    pub fn begin(&mut self, grid: &impl OccupancyGrid2d, options: DistanceOptions) -> Result<(), Error> {
        let whole = CellRect {
            x0: 0,
            y0: 0,
            x1: grid.width(),
            y1: grid.height(),
        };
        self.begin_window(grid, whole, options)
    }

    /// [`begin`](Self::begin) for the cells of a window.
    ///
    /// # Errors
    /// As [`compute_window`](Self::compute_window).
    pub fn begin_window(
        &mut self,
        grid: &impl OccupancyGrid2d,
        window: CellRect,
        options: DistanceOptions,
    ) -> Result<(), Error> {
        let region = Self::region(grid, window, options)?;
        let values = grid.value_traits();
        let obstacles = |gy: u32| {
            let start = gy as usize * grid.width() as usize;
            let row = start + region.x0 as usize..start + region.x1 as usize;
            let row = grid.data().get(row).unwrap_or_default();
            row.iter()
                .map(move |value| options.unknown.is_obstacle(&values, *value))
        };
        let place = Regions {
            size: [grid.width(), grid.height()],
            window,
            region,
        };
        self.begin_rows(place, grid.resolution(), options, obstacles)
    }

    /// Starts computing from rows of obstacles: `obstacles(gy)` tells of the cells of a row from the region's first
    /// column on whether they are.
    pub(crate) fn begin_rows<I: Iterator<Item = bool>>(
        &mut self,
        place: Regions,
        resolution: f32,
        options: DistanceOptions,
        obstacles: impl Fn(u32) -> I,
    ) -> Result<(), Error> {
        let Regions { size, window, region } = place;
        if size[0].max(size[1]) > MAX_SIDE {
            return Err(Error::SizeOverflow);
        }
        self.check(region)?;
        let (width, cells) = (region.width(), area(region));
        let reach = cap::<D>(options).reach();
        let mut rows = self
            .buffers
            .cells
            .get_mut(..cells)
            .unwrap_or_default()
            .chunks_mut(width.max(1) as usize);
        let mut before: &mut [D] = &mut [];
        for gy in region.y0..region.y1 {
            let row = rows.next().unwrap_or_default();
            if gy == region.y0 {
                columns::first(row, obstacles(gy));
                for distance in 1..=reach.min(gy) {
                    columns::beyond(row, distance, obstacles(gy - distance));
                }
            } else {
                columns::down(row, before, obstacles(gy));
            }
            before = row;
        }
        for distance in 1..=reach.min(size[1].saturating_sub(region.y1)) {
            columns::beyond(before, distance, obstacles(region.y1 + distance - 1));
        }

        self.resolution = resolution;
        self.options = options;
        self.window = window;
        self.region = region;
        self.rows = Rows::new(cap::<D>(options));
        self.rows_left = (2 * region.height()).saturating_sub(1);
        Ok(())
    }

    /// An error unless the buffers hold a region.
    pub(crate) fn check(&self, region: CellRect) -> Result<(), Error> {
        require(Buffer::Distances, area(region), self.buffers.cells.len())?;
        let vertices = region.width() as usize * if D::SIGNED { 2 } else { 1 };
        require(Buffer::Vertices, vertices, self.buffers.vertices.len())
    }

    /// Goes on computing for so many rows; returns how many are left. 0: the distances can be read.
    ///
    /// # Complexity
    /// Three cell visits per cell of a row in the first half, four and the vertices in the second.
    pub fn advance(&mut self, rows: u32) -> u32 {
        let height = self.region.height();
        for _ in 0..rows.min(self.rows_left) {
            match self.rows_left.checked_sub(height + 1) {
                Some(row) => self.sweep_up(row),
                None => self.lower(height - self.rows_left),
            }
            self.rows_left -= 1;
        }
        self.rows_left
    }

    /// The cells whose distances are, or are being, computed.
    pub fn window(&self) -> CellRect {
        self.window
    }

    /// The squared distances of the window's cells, row-major; empty while a computation has not ended.
    pub fn squared(&self) -> &[D] {
        let cells = if self.rows_left == 0 { area(self.window) } else { 0 };
        self.buffers.cells.get(..cells).unwrap_or_default()
    }

    /// The squared distance of a cell of the grid; outside the window, or while a computation has not ended: `None`.
    pub fn squared_at(&self, gx: u32, gy: u32) -> Option<D> {
        if !self.window.contains(gx, gy) {
            return None;
        }
        let (x, y) = (gx - self.window.x0, gy - self.window.y0);
        let index = y as usize * self.window.width() as usize + x as usize;
        self.squared().get(index).copied()
    }

    /// The distance of a cell in metres, negative inside obstacles if `D` is signed; outside the window, or while a
    /// computation has not ended: `None`.
    pub fn metres_at(&self, gx: u32, gy: u32) -> Option<f32> {
        self.squared_at(gx, gy).map(|squared| self.metres_of(squared))
    }

    /// The distances of the window's cells in metres, row-major, lazily; none while a computation has not ended.
    pub fn metres(&self) -> impl ExactSizeIterator<Item = f32> {
        self.squared().iter().map(|squared| self.metres_of(*squared))
    }

    /// The obstacle nearest to a cell of the window, by its distance; of several the one with the lowest index. `None`
    /// outside the window, and where there is no obstacle within the cap. An obstacle is nearest to itself.
    ///
    /// `grid` is the one that the distances were computed of; if it has changed since, an obstacle may not be found.
    ///
    /// # Complexity
    /// At most eight cell visits per cell of distance.
    pub fn nearest_obstacle(&self, grid: &impl OccupancyGrid2d, gx: u32, gy: u32) -> Option<(u32, u32)> {
        let cell = self.squared_at(gx, gy)?;
        if D::SIGNED && cell.is_obstacle() {
            return Some((gx, gy));
        }
        let squared = cell.squared();
        let (values, unknown) = (grid.value_traits(), self.options.unknown);
        let mut nearest: Option<usize> = None;
        let mut dy = squared.isqrt();
        for dx in 0..=dy.min(grid.width()) {
            let left = squared - dx * dx;
            while dy * dy > left {
                dy -= 1;
            }
            if dy * dy != left {
                continue;
            }
            for (sx, sy) in [(1, 1), (-1, 1), (1, -1), (-1, -1)] {
                let cell = (gx as i32 + sx * dx as i32, gy as i32 + sy * dy as i32);
                let Some(index) = grid.index_at(cell) else {
                    continue;
                };
                let obstacle = grid
                    .data_at(index)
                    .is_some_and(|v| unknown.is_obstacle(&values, v));
                if obstacle {
                    nearest = Some(nearest.map_or(index, |other| other.min(index)));
                }
            }
        }
        let (index, width) = (nearest? as u32, grid.width());
        Some((index.checked_rem(width)?, index.checked_div(width)?))
    }

    /// The cells that computing a window works on, one of [`DistanceBuffers::cells`] each: the window, and to its left
    /// and right what lies within the cap.
    ///
    /// # Errors
    /// [`Error::WindowOutside`] for a window that reaches out of the grid.
    pub fn region(
        grid: &impl OccupancyGrid2d,
        window: CellRect,
        options: DistanceOptions,
    ) -> Result<CellRect, Error> {
        let inside = window.x0 <= window.x1
            && window.y0 <= window.y1
            && window.x1 <= grid.width()
            && window.y1 <= grid.height();
        if !inside {
            return Err(Error::WindowOutside);
        }
        let reach = cap::<D>(options).reach();
        Ok(CellRect {
            x0: window.x0.saturating_sub(reach),
            x1: window.x1.saturating_add(reach).min(grid.width()),
            ..window
        })
    }

    fn sweep_up(&mut self, row: u32) {
        let width = self.region.width() as usize;
        let rows = self
            .buffers
            .cells
            .get_mut(row as usize * width..)
            .unwrap_or_default();
        if let Some((row, after)) = rows.split_at_mut_checked(width) {
            columns::up(row, after);
        }
    }

    fn lower(&mut self, row: u32) {
        let (region, window) = (self.region.width(), self.window.width());
        let place = Place {
            from: row as usize * region as usize,
            width: region,
            left: self.window.x0 - self.region.x0,
            to: row as usize * window as usize,
            window,
        };
        let DistanceBuffers { cells, vertices } = &mut self.buffers;
        self.rows.lower(cells, vertices, place);
    }

    fn metres_of(&self, cell: D) -> f32 {
        let metres = self.resolution * math::sqrt(cell.squared() as f32);
        if D::SIGNED && cell.is_obstacle() {
            -metres
        } else {
            metres
        }
    }
}

/// Where a computation works.
pub(crate) struct Regions {
    /// Columns and rows of the grid.
    pub size: [u32; 2],
    /// Whose distances are asked for.
    pub window: CellRect,
    /// The cells it works on, see [`DistanceMap::region`].
    pub region: CellRect,
}

const NOTHING: CellRect = CellRect {
    x0: 0,
    y0: 0,
    x1: 0,
    y1: 0,
};

fn area(rect: CellRect) -> usize {
    rect.width() as usize * rect.height() as usize
}

/// The cap that options ask for and a map can hold.
fn cap<D: DistanceCell>(options: DistanceOptions) -> Cap {
    Cap(options.max_squared.unwrap_or(u32::MAX).min(D::MAX_SQUARED))
}
