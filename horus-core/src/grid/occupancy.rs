use super::integrate::{self, ChangeSink};
use super::{FREE, LaserScan, OCCUPIED, OCCUPIED_FROM, ScanModel, ScanReport, ScanWorkspace, UNKNOWN, text};
use crate::error::{Buffer, Error, require};
use crate::geometry::{Bounds, CellRect, GridInfo, Pose2D};
use crate::storage;

/// A rolling grid of occupancy values over caller-provided storage `S`.
///
/// Cells are `i8`: -1 unknown, 0 free, 1..49 probably free, 50..99 probably occupied, 100
/// occupied; row-major, `index = gy * width + gx`, row 0 has the lowest y. The capacity is the
/// storage's length, checked once; width and height are chosen at run time. `S` may be an array,
/// `&mut [i8]`, a `Vec`, or, for reading, a `&'static [i8]` in flash.
///
/// Source: HORUS `OccupancyGrid` (fields and method names).
///
/// # Examples
/// ```
/// use horus_core::prelude::*;
///
/// let mut cells = [0i8; 200 * 200];
/// let origin = Pose2D::new(-5.0, -5.0, 0.0);
/// let mut grid = OccupancyGrid::new_in(&mut cells[..], 200, 200, 0.05, origin)?;
/// assert!(grid.set_occupancy(100, 100, 100));
/// assert_eq!(grid.world_to_grid(1.5, 2.0), Some((130, 140)));
/// assert!(!grid.is_free(1.5, 2.0), "a new grid is unknown everywhere");
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug)]
// In this order: a number between the texts makes moving a grid a few loads and stores, where one
// block of both would be a call of `memcpy`.
#[repr(C)]
pub struct OccupancyGrid<S> {
    info: GridInfo,
    /// Name of the frame the grid lies in, UTF-8, zero-filled.
    pub frame_id: [u8; 32],
    /// Nanoseconds since the epoch its user keeps.
    pub timestamp_ns: u64,
    /// Free-form text, UTF-8, zero-filled.
    pub metadata: [u8; 64],
    cells: S,
}

/// A grid with room for `N` cells inside itself.
///
/// `static GRID: ... = StaticOccupancyGrid::empty()` lies in `.bss`: no flash image, no copy on
/// the stack. Give it its size with [`reset`](OccupancyGrid::reset).
pub type StaticOccupancyGrid<const N: usize> = OccupancyGrid<[i8; N]>;

impl<const N: usize> StaticOccupancyGrid<N> {
    /// A 0 x 0 grid, all bits zero: every point is outside until [`reset`](Self::reset).
    pub const fn empty() -> Self {
        Self {
            info: GridInfo::EMPTY,
            frame_id: [0; 32],
            metadata: [0; 64],
            timestamp_ns: 0,
            cells: [0; N],
        }
    }
}

impl<S: AsRef<[i8]> + AsMut<[i8]>> OccupancyGrid<S> {
    /// A grid of `width` x `height` unknown cells of `resolution` metres over `cells`; the corner
    /// of cell (0, 0) lies at `origin` in the world frame. 0 x 0 is legal.
    ///
    /// # Errors
    /// [`Error::InvalidResolution`], [`Error::NonFinitePose`], [`Error::SizeOverflow`];
    /// [`Error::BufferTooSmall`] if `cells` is shorter than `width * height`.
    ///
    /// # Complexity
    /// One write per cell.
    pub fn new_in(cells: S, width: u32, height: u32, resolution: f32, origin: Pose2D) -> Result<Self, Error> {
        let info = GridInfo::new(width, height, resolution, origin)?;
        require(Buffer::Cells, info.cells(), cells.as_ref().len())?;
        let mut cells = cells;
        let known = cells.as_mut().get_mut(..info.cells());
        storage::fill(known.unwrap_or_default(), UNKNOWN);
        Ok(Self {
            info,
            frame_id: [0; 32],
            metadata: [0; 64],
            timestamp_ns: 0,
            cells,
        })
    }

    /// Gives the grid a new size and place, in place; every cell becomes unknown and the texts
    /// and the time stamp are cleared. On an error nothing changes.
    ///
    /// # Errors
    /// As [`new_in`](Self::new_in).
    pub fn reset(&mut self, width: u32, height: u32, resolution: f32, origin: Pose2D) -> Result<(), Error> {
        let info = GridInfo::new(width, height, resolution, origin)?;
        require(Buffer::Cells, info.cells(), self.cells.as_ref().len())?;
        self.info = info;
        self.frame_id = [0; 32];
        self.metadata = [0; 64];
        self.timestamp_ns = 0;
        self.clear();
        Ok(())
    }

    /// Makes every cell unknown; the window stays where it is.
    pub fn clear(&mut self) {
        storage::fill(self.data_mut(), UNKNOWN);
    }

    /// Sets a cell, clamped to -1..=100; outside the grid: `false`, nothing changes.
    pub fn set_occupancy(&mut self, gx: u32, gy: u32, value: i8) -> bool {
        let Some(i) = self.info.index(gx, gy) else {
            return false;
        };
        match self.cells.as_mut().get_mut(i) {
            Some(cell) => {
                *cell = value.clamp(UNKNOWN, OCCUPIED);
                true
            }
            None => false,
        }
    }

    /// Replaces all cells, row-major, each clamped to -1..=100.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`] unless `values` has one value per cell; nothing changes then.
    pub fn load(&mut self, values: &[i8]) -> Result<(), Error> {
        let cells = self.data_mut();
        if values.len() != cells.len() {
            return Err(Error::LengthMismatch {
                needed: cells.len(),
                given: values.len(),
            });
        }
        for (cell, value) in cells.iter_mut().zip(values) {
            *cell = (*value).clamp(UNKNOWN, OCCUPIED);
        }
        Ok(())
    }

    /// Moves the window by whole cells along the grid's axes so that `pose` (world frame, metres)
    /// is nearest to its centre; returns the cells moved along x and y. Cells keep their contents,
    /// new ones are unknown; a jump of a whole window clears all; a zero shift costs nothing.
    ///
    /// # Errors
    /// [`Error::NonFinitePose`], [`Error::OffsetOutOfRange`]; nothing changes then.
    ///
    /// # Complexity
    /// One read and one write per cell, none for a zero shift.
    pub fn recenter(&mut self, pose: Pose2D) -> Result<[i32; 2], Error> {
        let shift = self.info.shift_to(pose)?;
        self.shift_cells(shift);
        self.info.shift_by(shift);
        Ok(shift)
    }

    /// Moves the window to another offset, within 2^30 cells; returns the cells moved, saturating.
    pub(crate) fn move_to(&mut self, offset: [i32; 2]) -> [i32; 2] {
        let ([x, y], [from_x, from_y]) = (offset, self.info.offset());
        let shift = [x.saturating_sub(from_x), y.saturating_sub(from_y)];
        self.shift_cells(shift);
        self.info.move_to(offset);
        shift
    }

    fn shift_cells(&mut self, shift: [i32; 2]) {
        let (width, height) = (self.width(), self.height());
        storage::shift_cells(self.data_mut(), width, height, shift, UNKNOWN);
    }

    /// Integrates a laser scan taken at `sensor_pose` (world frame, the lidar's own mounting pose
    /// applied): beams clear the cells up to their ends, then hits are marked, so a hit is never
    /// erased by a neighbour beam of the same scan.
    ///
    /// Ranges follow REP 117: NaN, -inf and below `range_min` are ignored, +inf and from
    /// `range_max` on are misses at `range_max`. Beams are cut at the border, the sensor may stand
    /// outside the map; a beam that ends more than 2^30 cells away is ignored and counted.
    ///
    /// # Errors
    /// [`Error::NonFinitePose`], [`Error::InvalidScan`], [`Error::InvalidModel`];
    /// [`Error::BufferTooSmall`] if the workspace has fewer slots than the scan has beams or,
    /// for [`ScanModel::Accumulate`], too few bits. Nothing changes then.
    ///
    /// # Complexity
    /// At most `beams * (width + height)` cell visits and three end points per beam; trigonometry
    /// once per scan, and once per beam when the scan's angles change.
    pub fn integrate_scan(
        &mut self,
        scan: &LaserScan<'_>,
        sensor_pose: Pose2D,
        model: ScanModel,
        workspace: &mut ScanWorkspace<'_>,
    ) -> Result<ScanReport, Error> {
        let mut changed = Bounds::EMPTY;
        self.integrate_scan_into(scan, sensor_pose, model, workspace, &mut changed)
    }

    pub(crate) fn integrate_scan_into(
        &mut self,
        scan: &LaserScan<'_>,
        sensor_pose: Pose2D,
        model: ScanModel,
        workspace: &mut ScanWorkspace<'_>,
        sink: &mut impl ChangeSink,
    ) -> Result<ScanReport, Error> {
        let info = self.info;
        integrate::integrate(self.data_mut(), &info, scan, sensor_pose, model, workspace, sink)
    }

    /// Sets a cell and tells whether its value changed; `None` outside.
    pub(crate) fn replace(&mut self, gx: u32, gy: u32, value: i8) -> Option<bool> {
        let i = self.info.index(gx, gy)?;
        let cell = self.cells.as_mut().get_mut(i)?;
        let value = value.clamp(UNKNOWN, OCCUPIED);
        Some(core::mem::replace(cell, value) != value)
    }

    fn data_mut(&mut self) -> &mut [i8] {
        let n = self.info.cells();
        self.cells.as_mut().get_mut(..n).unwrap_or_default()
    }
}

impl<'a> OccupancyGrid<&'a [i8]> {
    /// A read-only grid over existing values, for example a prior map in flash. Values outside
    /// -1..=100 are read as they are.
    ///
    /// # Errors
    /// As [`new_in`](OccupancyGrid::new_in).
    pub fn view(
        cells: &'a [i8],
        width: u32,
        height: u32,
        resolution: f32,
        origin: Pose2D,
    ) -> Result<Self, Error> {
        let info = GridInfo::new(width, height, resolution, origin)?;
        require(Buffer::Cells, info.cells(), cells.len())?;
        Ok(Self {
            info,
            frame_id: [0; 32],
            metadata: [0; 64],
            timestamp_ns: 0,
            cells,
        })
    }
}

impl<S: AsRef<[i8]>> OccupancyGrid<S> {
    /// Size, resolution and place.
    pub const fn info(&self) -> &GridInfo {
        &self.info
    }

    /// Metres per cell.
    pub const fn resolution(&self) -> f32 {
        self.info.resolution()
    }

    /// Columns.
    pub const fn width(&self) -> u32 {
        self.info.width()
    }

    /// Rows.
    pub const fn height(&self) -> u32 {
        self.info.height()
    }

    /// World pose of the corner of cell (0, 0); it moves with the window.
    pub fn origin(&self) -> Pose2D {
        self.info.origin()
    }

    /// All cell values, row-major.
    pub fn data(&self) -> &[i8] {
        self.cells.as_ref().get(..self.info.cells()).unwrap_or_default()
    }

    /// The cell that holds a world point (metres); outside the grid, NaN or infinite: `None`.
    ///
    /// A point on a nominal cell boundary belongs to the upper cell.
    pub fn world_to_grid(&self, x: f32, y: f32) -> Option<(u32, u32)> {
        self.info.world_to_grid(x, y)
    }

    /// World coordinates (metres) of a cell's centre; outside the grid: `None`.
    pub fn grid_to_world(&self, gx: u32, gy: u32) -> Option<(f32, f32)> {
        self.info.grid_to_world(gx, gy)
    }

    /// A cell's value; outside the grid: `None`.
    pub fn occupancy(&self, gx: u32, gy: u32) -> Option<i8> {
        self.cells.as_ref().get(self.info.index(gx, gy)?).copied()
    }

    /// True if the world point (metres) lies in a cell with a value of 0..50. Unknown and outside:
    /// false.
    pub fn is_free(&self, x: f32, y: f32) -> bool {
        self.value_at(x, y)
            .is_some_and(|v| (FREE..OCCUPIED_FROM).contains(&v))
    }

    /// True if the world point (metres) lies in a cell with a value of 50 or more. Unknown and
    /// outside: false.
    pub fn is_occupied(&self, x: f32, y: f32) -> bool {
        self.value_at(x, y).is_some_and(|v| v >= OCCUPIED_FROM)
    }

    fn value_at(&self, x: f32, y: f32) -> Option<i8> {
        let (gx, gy) = self.world_to_grid(x, y)?;
        self.occupancy(gx, gy)
    }

    /// The frame's name; empty if none was set.
    pub fn frame_id_str(&self) -> &str {
        text::read(&self.frame_id)
    }

    /// The free-form text.
    pub fn metadata_str(&self) -> &str {
        text::read(&self.metadata)
    }

    /// Names the frame; a longer name is cut at a character boundary after at most 32 bytes.
    pub fn set_frame_id(&mut self, name: &str) {
        text::write(&mut self.frame_id, name);
    }

    /// Sets the free-form text; a longer one is cut at a character boundary after at most 64 bytes.
    pub fn set_metadata(&mut self, text: &str) {
        text::write(&mut self.metadata, text);
    }
}

impl ChangeSink for Bounds {
    fn changed(&mut self, gx: u32, gy: u32) {
        self.add(gx, gy);
    }

    fn rect(&self) -> Option<CellRect> {
        Bounds::rect(self)
    }
}
