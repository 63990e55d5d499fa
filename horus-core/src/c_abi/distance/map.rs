use core::ffi::c_void;
use core::marker::PhantomData;

use super::operations::Operations;
use crate::c_abi::arena::{Arena, Room, Zeroed};
use crate::c_abi::call::{Call, Claims, Plain};
use crate::c_abi::grid::horus_grid;
use crate::c_abi::grid_reads::view;
use crate::c_abi::object::{self, Make, Object};
use crate::c_abi::status::horus_status;
use crate::distance::{
    DistanceBuffers, DistanceCell, DistanceMap, DistanceOptions, EnvelopeVertex, UnknownAs,
};
use crate::geometry::{CellRect, GridInfo, Pose2D};

/// Exact distances from the cells of a grid to the nearest obstacle. It lies in memory of its user.
pub struct horus_distance_map {
    _memory: (),
}

/// Room and layout of a distance map.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct horus_distance_map_config {
    /// Columns that there is room for.
    pub width: u32,
    /// Rows that there is room for.
    pub height: u32,
    /// Bytes per cell, 2 or 4: squared distances up to 65535 or 4294967295, half of that if signed.
    pub cell_bytes: u8,
    /// Not 0: an obstacle holds minus the squared distance to the nearest cell that is none.
    pub is_signed: u8,
}

// SAFETY: numbers.
unsafe impl Plain for horus_distance_map_config {}

/// How distances are computed.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct horus_distance_options {
    /// The cap in squared cells: what is farther away, or does not exist, reads as the cap. More
    /// than the map's cells hold: the most that they hold.
    pub max_squared: u32,
    /// Not 0: unknown cells are obstacles, too.
    pub unknown_is_obstacle: u8,
}

// SAFETY: numbers.
unsafe impl Plain for horus_distance_options {}

impl From<horus_distance_options> for DistanceOptions {
    fn from(options: horus_distance_options) -> Self {
        Self {
            max_squared: Some(options.max_squared),
            unknown: match options.unknown_is_obstacle {
                0 => UnknownAs::Clear,
                _ => UnknownAs::Obstacle,
            },
        }
    }
}

/// A distance map with cells of any type. The map lies among its buffers: its functions are found
/// through it.
pub(in crate::c_abi) struct AnyDistanceMap(&'static mut dyn Operations);

impl Object for AnyDistanceMap {
    const TAG: u32 = u32::from_le_bytes(*b"HDm1");
    type Handle = horus_distance_map;
}

/// The buffers of a map with cells of `D`.
struct Buffers<D: 'static> {
    map: Room<DistanceMap<'static, D>>,
    vertices: &'static mut [EnvelopeVertex],
    cells: &'static mut [D],
}

/// Makes maps with cells of `D`.
struct WithCells<D>(PhantomData<D>);

impl<D: DistanceCell + Zeroed> Make for WithCells<D> {
    type Object = AnyDistanceMap;
    type Config = horus_distance_map_config;
    type Buffers = Buffers<D>;

    /// The most aligned first, so that nothing lies between them.
    fn buffers(config: &Self::Config, arena: &mut Arena) -> Result<Self::Buffers, horus_status> {
        let place = Pose2D::new(0.0, 0.0, 0.0);
        let cells = GridInfo::new(config.width, config.height, 1.0, place)?.cells();
        let per_column = if D::SIGNED { 2 } else { 1 };
        Ok(Buffers {
            map: arena.room()?,
            vertices: arena.take(per_column * config.width as usize)?,
            cells: arena.take(cells)?,
        })
    }

    fn make(_: &Self::Config, buffers: Self::Buffers) -> Result<AnyDistanceMap, horus_status> {
        let Buffers { map, vertices, cells } = buffers;
        let buffers = DistanceBuffers { cells, vertices };
        Ok(AnyDistanceMap(map.put(DistanceMap::new_in(buffers))?))
    }
}

/// Does the same for whichever cells a configuration asks for.
macro_rules! with_cells {
    ($config:expr, $cells:ident => $body:expr) => {
        match ($config.cell_bytes, $config.is_signed) {
            (2, 0) => {
                type $cells = WithCells<u16>;
                $body
            }
            (2, _) => {
                type $cells = WithCells<i16>;
                $body
            }
            (4, 0) => {
                type $cells = WithCells<u32>;
                $body
            }
            (4, _) => {
                type $cells = WithCells<i32>;
                $body
            }
            _ => Err(horus_status::InvalidChoice),
        }
    };
}

/// Bytes of memory that such a distance map takes.
///
/// Fails with HORUS_STATUS_SIZE_OVERFLOW, HORUS_STATUS_INVALID_CHOICE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_distance_map_bytes(
    config: *const horus_distance_map_config,
    bytes: *mut usize,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let config = claims.input(config)?;
        let bytes = claims.output(bytes)?;
        bytes.write(with_cells!(config, Cells => object::bytes::<Cells>(&config))?);
        Ok(())
    })
}

/// Makes a distance map of nothing in `length` bytes of memory.
///
/// Fails as horus_distance_map_bytes() does, and with HORUS_STATUS_BUFFER_TOO_SMALL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_distance_map_init(
    memory: *mut c_void,
    length: usize,
    config: *const horus_distance_map_config,
    map: *mut *mut horus_distance_map,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let chosen = claims.input(config)?;
        with_cells!(chosen, Cells => object::init::<Cells>(claims, memory, length, config, map))
    })
}

/// Computes the distances of all cells of a grid or, unless `window` is NULL, of a window of it:
/// obstacles outside the window count as well. The map needs room for the grid's columns, and for
/// the window's cells with all columns within the cap left and right of them.
///
/// Fails with HORUS_STATUS_SIZE_OVERFLOW for a grid with a side above 32767 cells,
/// HORUS_STATUS_BUFFER_TOO_SMALL, HORUS_STATUS_OUTSIDE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_distance_map_compute(
    map: *mut horus_distance_map,
    grid: *const horus_grid,
    window: *const CellRect,
    options: horus_distance_options,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        begin(claims, map, grid, window, options)?.advance(u32::MAX);
        Ok(())
    })
}

/// Starts what horus_distance_map_compute() does: reads the grid, which may change afterwards, and
/// leaves the rest to horus_distance_map_advance().
///
/// Fails as horus_distance_map_compute() does.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_distance_map_begin(
    map: *mut horus_distance_map,
    grid: *const horus_grid,
    window: *const CellRect,
    options: horus_distance_options,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| begin(claims, map, grid, window, options).map(|_| ()))
}

/// Goes on computing for so many rows; *left = rows left, 0: the distances can be read.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_distance_map_advance(
    map: *mut horus_distance_map,
    rows: u32,
    left: *mut u32,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let map = claims.object_mut::<AnyDistanceMap>(map)?;
        claims.output(left)?.write(map.0.advance(rows));
        Ok(())
    })
}

fn begin<'c>(
    claims: &mut Claims<'c>,
    map: *mut horus_distance_map,
    grid: *const horus_grid,
    window: *const CellRect,
    options: horus_distance_options,
) -> Result<&'c mut dyn Operations, horus_status> {
    let map = claims.object_mut::<AnyDistanceMap>(map)?;
    let grid = view(claims, grid)?;
    let window = if window.is_null() {
        None
    } else {
        Some(claims.input(window)?)
    };
    map.0.begin(grid, window, options.into())?;
    Ok(&mut *map.0)
}

/// The operations of a map that is read.
pub(super) fn distance_map<'c>(
    claims: &mut Claims<'c>,
    map: *const horus_distance_map,
) -> Result<&'c dyn Operations, horus_status> {
    Ok(&*claims.object::<AnyDistanceMap>(map)?.0)
}
