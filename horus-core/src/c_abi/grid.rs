//! The occupancy grid.

use core::ffi::{c_char, c_void};

use super::arena::Arena;
use super::call::{Call, Claims, Plain};
use super::geometry::horus_shift;
use super::object::{self, Make, Object};
use super::scan::{ScanCall, horus_laser_scan, horus_scan_model, horus_scan_report, horus_scan_workspace};
use super::status::{horus_status, inside};
use super::text;
use crate::geometry::{GridInfo, Pose2D};
use crate::grid::OccupancyGrid;

/// A rolling grid of occupancy values: -1 unknown, 0 free .. 100 occupied, row by row from the
/// lowest y. It lies in memory of its user.
pub struct horus_grid {
    _memory: (),
}

/// Size and place of a grid.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct horus_grid_config {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Metres per cell.
    pub resolution: f32,
    /// World pose of the corner (not the centre) of cell (0, 0).
    pub origin: Pose2D,
}

// SAFETY: numbers.
unsafe impl Plain for horus_grid_config {}

/// Size, resolution and place of a grid as it is now.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct horus_map_info {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Metres per cell.
    pub resolution: f32,
    /// World pose of the corner of cell (0, 0); it moves with the window.
    pub origin: Pose2D,
    /// Cells the window has moved since the grid was made.
    pub offset: horus_shift,
}

pub(super) type Grid = OccupancyGrid<&'static mut [i8]>;

impl horus_grid_config {
    /// Cells of the grid, if it can exist.
    pub(super) fn cells(&self) -> Result<usize, horus_status> {
        Ok(GridInfo::new(self.width, self.height, self.resolution, self.origin)?.cells())
    }

    pub(super) fn grid(&self, cells: &'static mut [i8]) -> Result<Grid, horus_status> {
        let grid = OccupancyGrid::new_in(cells, self.width, self.height, self.resolution, self.origin)?;
        Ok(grid)
    }
}

impl Object for Grid {
    const TAG: u32 = u32::from_le_bytes(*b"HGr1");
    type Handle = horus_grid;
}

impl Make for Grid {
    type Object = Self;
    type Config = horus_grid_config;
    type Buffers = &'static mut [i8];

    fn buffers(config: &Self::Config, arena: &mut Arena) -> Result<Self::Buffers, horus_status> {
        arena.take(config.cells()?)
    }

    fn make(config: &Self::Config, cells: Self::Buffers) -> Result<Self, horus_status> {
        config.grid(cells)
    }
}

impl From<&GridInfo> for horus_map_info {
    fn from(info: &GridInfo) -> Self {
        Self {
            width: info.width(),
            height: info.height(),
            resolution: info.resolution(),
            origin: info.origin(),
            offset: info.offset().into(),
        }
    }
}

/// Values for all cells; with a wrong count, nobody looks whether they are there.
pub(super) fn one_per_cell<'c>(
    claims: &mut Claims<'c>,
    grid: &Grid,
    values: *const i8,
    count: usize,
) -> Result<&'c [i8], horus_status> {
    if count != grid.info().cells() {
        return Err(horus_status::LengthMismatch);
    }
    claims.slice(values, count)
}

/// Bytes of memory that such a grid takes: one per cell, and a few.
///
/// Fails with HORUS_STATUS_INVALID_RESOLUTION, HORUS_STATUS_NON_FINITE_POSE,
/// HORUS_STATUS_SIZE_OVERFLOW.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_bytes(
    config: *const horus_grid_config,
    bytes: *mut usize,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let config = claims.input(config)?;
        claims.output(bytes)?.write(object::bytes::<Grid>(&config)?);
        Ok(())
    })
}

/// Makes a grid of unknown cells in `length` bytes of memory. 0 x 0 cells are legal.
///
/// Fails as horus_grid_bytes does, and with HORUS_STATUS_BUFFER_TOO_SMALL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_init(
    memory: *mut c_void,
    length: usize,
    config: *const horus_grid_config,
    grid: *mut *mut horus_grid,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| object::init::<Grid>(claims, memory, length, config, grid))
}

/// Gives the grid a new size and place; every cell becomes unknown, texts and time are cleared.
///
/// Fails as horus_grid_bytes does; with HORUS_STATUS_BUFFER_TOO_SMALL if it was made with fewer
/// cells.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_reset(
    grid: *mut horus_grid,
    config: *const horus_grid_config,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let config = claims.input(config)?;
        let grid = claims.object_mut::<Grid>(grid)?;
        grid.reset(config.width, config.height, config.resolution, config.origin)?;
        Ok(())
    })
}

/// Makes every cell unknown; the window stays where it is.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_clear(grid: *mut horus_grid) -> horus_status {
    // SAFETY: the pointer is the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        claims.object_mut::<Grid>(grid)?.clear();
        Ok(())
    })
}

/// Sets a cell, clamped to -1 .. 100.
///
/// Fails with HORUS_STATUS_OUTSIDE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_set_occupancy(
    grid: *mut horus_grid,
    gx: u32,
    gy: u32,
    value: i8,
) -> horus_status {
    // SAFETY: the pointer is the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let grid = claims.object_mut::<Grid>(grid)?;
        inside(grid.set_occupancy(gx, gy, value).then_some(()))
    })
}

/// Replaces all cells, row by row, each clamped to -1 .. 100.
///
/// Fails with HORUS_STATUS_LENGTH_MISMATCH unless count is width * height.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_load(
    grid: *mut horus_grid,
    values: *const i8,
    count: usize,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let grid = claims.object_mut::<Grid>(grid)?;
        let values = one_per_cell(claims, grid, values, count)?;
        grid.load(values)?;
        Ok(())
    })
}

/// Moves the window by whole cells so that the pose is nearest to its centre; tells by how many
/// (`shift` may be NULL). Cells keep their contents, new ones are unknown.
///
/// Fails with HORUS_STATUS_NON_FINITE_POSE, HORUS_STATUS_OFFSET_OUT_OF_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_recenter(
    grid: *mut horus_grid,
    pose: Pose2D,
    shift: *mut horus_shift,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let grid = claims.object_mut::<Grid>(grid)?;
        let shift = claims.output_or_null(shift)?;
        shift.write(grid.recenter(pose)?.into());
        Ok(())
    })
}

/// Integrates a scan taken at a world pose of the sensor: beams clear cells up to their ends, then
/// hits are marked. `report` may be NULL.
///
/// Fails with HORUS_STATUS_NON_FINITE_POSE, HORUS_STATUS_INVALID_SCAN, HORUS_STATUS_INVALID_MODEL,
/// HORUS_STATUS_INVALID_CHOICE, HORUS_STATUS_WORKSPACE_TOO_SMALL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_integrate_scan(
    grid: *mut horus_grid,
    scan: *const horus_laser_scan,
    sensor_pose: Pose2D,
    model: horus_scan_model,
    workspace: *mut horus_scan_workspace,
    report: *mut horus_scan_report,
) -> horus_status {
    let call = ScanCall {
        scan,
        model,
        workspace,
        report,
    };
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let grid = claims.object_mut::<Grid>(grid)?;
        call.run(claims, |scan, model, workspace| {
            grid.integrate_scan(scan, sensor_pose, model, workspace)
        })
    })
}

/// Names the frame (UTF-8, at most 32 bytes are kept) and sets the time, in nanoseconds.
///
/// Fails with HORUS_STATUS_INVALID_TEXT.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_set_header(
    grid: *mut horus_grid,
    frame_id: *const c_char,
    length: usize,
    timestamp_ns: u64,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let grid = claims.object_mut::<Grid>(grid)?;
        grid.set_frame_id(text::input(claims, frame_id, length)?);
        grid.timestamp_ns = timestamp_ns;
        Ok(())
    })
}

/// Sets the grid's free-form text (UTF-8, at most 64 bytes are kept).
///
/// Fails with HORUS_STATUS_INVALID_TEXT.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_set_metadata(
    grid: *mut horus_grid,
    metadata: *const c_char,
    length: usize,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let grid = claims.object_mut::<Grid>(grid)?;
        grid.set_metadata(text::input(claims, metadata, length)?);
        Ok(())
    })
}
