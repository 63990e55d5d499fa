use core::ffi::c_void;
use core::marker::PhantomData;

use super::horus_cost_params;
use super::operations::Operations;
use crate::c_abi::arena::{Arena, Room, Zeroed};
use crate::c_abi::call::{Call, Claims, Plain};
use crate::c_abi::grid::{Grid, horus_grid_config};
use crate::c_abi::object::{self, Make, Object};
use crate::c_abi::status::horus_status;
use crate::costmap::{CostBuffers, CostMap, CostTables, FieldCell, bit_words, scratch_words};

/// An occupancy grid with inflated costs that follow its every change. Costs are bytes: 0 free ..
/// lethal_cost, 255 unknown. It lies in memory of its user.
pub struct horus_cost_map {
    _memory: (),
}

/// Size, place, parameters and layout of a cost map.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct horus_cost_map_config {
    /// The grid inside.
    pub grid: horus_grid_config,
    /// How costs follow from cells.
    pub params: horus_cost_params,
    /// Bytes per cell of the distance field: 1 for costs that reach up to 15 cells, 2 for up to 255.
    pub field_bytes: u8,
    /// Not 0: keep the costs of the last update as bytes, one per cell, for horus_cost_map_costs().
    pub keep_costs: u8,
}

// SAFETY: numbers.
unsafe impl Plain for horus_cost_map_config {}

/// A cost map with either field. The map lies among its buffers: so its functions are found
/// through it, and an image holds only those of the fields that it makes maps with.
pub(in crate::c_abi) struct AnyCostMap(&'static mut dyn Operations);

impl AnyCostMap {
    /// The map, to be changed.
    pub(in crate::c_abi) fn operations(&mut self) -> &mut (dyn Operations + 'static) {
        self.0
    }

    /// The grid inside.
    pub(in crate::c_abi) fn grid(&self) -> &Grid {
        self.0.grid()
    }
}

impl Object for AnyCostMap {
    const TAG: u32 = u32::from_le_bytes(*b"HCm1");
    type Handle = horus_cost_map;
}

/// The buffers of a map with a field of `F`.
pub(in crate::c_abi) struct Buffers<F: FieldCell> {
    map: Room<CostMap<'static, F>>,
    /// One, or none when only measured.
    tables: &'static mut [CostTables<F>],
    scratch: &'static mut [u32],
    bits: &'static mut [u32],
    field: &'static mut [F],
    cells: &'static mut [i8],
    costs: Option<&'static mut [u8]>,
}

/// Makes maps with a field of `F`.
pub(in crate::c_abi) struct WithField<F>(PhantomData<F>);

impl<F: FieldCell + Zeroed> Make for WithField<F> {
    type Object = AnyCostMap;
    type Config = horus_cost_map_config;
    type Buffers = Buffers<F>;

    /// The most aligned first, so that nothing lies between them.
    fn buffers(config: &Self::Config, arena: &mut Arena) -> Result<Self::Buffers, horus_status> {
        if usize::from(config.field_bytes) != size_of::<F>() {
            return Err(horus_status::InvalidChoice);
        }
        let cells = config.grid.cells()?;
        config.params.params()?.validate()?;
        Ok(Buffers {
            map: arena.room()?,
            tables: arena.take(1)?,
            // Enough for every radius that the field can hold: new parameters always fit.
            scratch: arena.take(scratch_words(F::MAX_RADIUS.min(31)))?,
            bits: arena.take(bit_words(config.grid.width, config.grid.height))?,
            field: arena.take(cells)?,
            cells: arena.take(cells)?,
            costs: match config.keep_costs {
                0 => None,
                _ => Some(arena.take(cells)?),
            },
        })
    }

    fn make(config: &Self::Config, buffers: Self::Buffers) -> Result<AnyCostMap, horus_status> {
        let grid = config.grid.grid(buffers.cells)?;
        let costs = CostBuffers {
            bits: buffers.bits,
            field: buffers.field,
            scratch: buffers.scratch,
            costs: buffers.costs,
            tables: buffers.tables.first_mut().ok_or(horus_status::BufferTooSmall)?,
        };
        let map = CostMap::new_in(grid, costs, config.params.params()?)?;
        Ok(AnyCostMap(buffers.map.put(map)?))
    }
}

/// Bytes of memory that such a cost map takes.
///
/// Fails with HORUS_STATUS_INVALID_RESOLUTION, HORUS_STATUS_NON_FINITE_POSE,
/// HORUS_STATUS_SIZE_OVERFLOW, HORUS_STATUS_INVALID_CHOICE, and one of HORUS_STATUS_INVALID_... for
/// a parameter.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_bytes(
    config: *const horus_cost_map_config,
    bytes: *mut usize,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let config = claims.input(config)?;
        let bytes = claims.output(bytes)?;
        bytes.write(match config.field_bytes {
            1 => object::bytes::<WithField<u8>>(&config)?,
            _ => object::bytes::<WithField<u16>>(&config)?,
        });
        Ok(())
    })
}

/// Makes a cost map of unknown cells in `length` bytes of memory and computes its costs.
///
/// Fails as horus_cost_map_bytes() does, and with HORUS_STATUS_BUFFER_TOO_SMALL; with
/// HORUS_STATUS_RADIUS_TOO_LARGE the memory holds no object.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_init(
    memory: *mut c_void,
    length: usize,
    config: *const horus_cost_map_config,
    map: *mut *mut horus_cost_map,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| match claims.input(config)?.field_bytes {
        1 => object::init::<WithField<u8>>(claims, memory, length, config, map),
        _ => object::init::<WithField<u16>>(claims, memory, length, config, map),
    })
}

/// horus_cost_map_init() for a one-byte field only: an image that makes its maps with it does not
/// hold the code for two bytes.
///
/// Fails as it does; with HORUS_STATUS_INVALID_CHOICE unless field_bytes is 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_init_1(
    memory: *mut c_void,
    length: usize,
    config: *const horus_cost_map_config,
    map: *mut *mut horus_cost_map,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| object::init::<WithField<u8>>(claims, memory, length, config, map))
}

/// horus_cost_map_init() for a two-byte field only, likewise.
///
/// Fails as it does; with HORUS_STATUS_INVALID_CHOICE unless field_bytes is 2.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_init_2(
    memory: *mut c_void,
    length: usize,
    config: *const horus_cost_map_config,
    map: *mut *mut horus_cost_map,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }
        .run(|claims| object::init::<WithField<u16>>(claims, memory, length, config, map))
}

/// The operations of a map that is read.
pub(super) fn cost_map<'c>(
    claims: &mut Claims<'c>,
    map: *const horus_cost_map,
) -> Result<&'c dyn Operations, horus_status> {
    Ok(&*claims.object::<AnyCostMap>(map)?.0)
}

/// The operations of a map that is changed.
pub(super) fn cost_map_mut<'c>(
    claims: &mut Claims<'c>,
    map: *mut horus_cost_map,
) -> Result<&'c mut dyn Operations, horus_status> {
    Ok(&mut *claims.object_mut::<AnyCostMap>(map)?.0)
}
