use core::ffi::c_void;

use super::horus_cost_params;
use crate::c_abi::arena::{Arena, Zeroed};
use crate::c_abi::call::{Call, Plain};
use crate::c_abi::grid::{Grid, horus_grid_config};
use crate::c_abi::object::{self, Object};
use crate::c_abi::sizes::{SCRATCH_1, SCRATCH_2};
use crate::c_abi::status::horus_status;
use crate::costmap::{CostBuffers, CostMap, CostTables, FieldCell, bit_words};

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

/// A cost map with either field.
pub(in crate::c_abi) enum AnyCostMap {
    OneByte(CostMap<'static, u8>),
    TwoBytes(CostMap<'static, u16>),
}

/// The same expression for either map.
macro_rules! each {
    ($any:expr, $map:ident => $body:expr) => {
        match $any {
            $crate::c_abi::cost_map::AnyCostMap::OneByte($map) => $body,
            $crate::c_abi::cost_map::AnyCostMap::TwoBytes($map) => $body,
        }
    };
}
pub(super) use each;

impl AnyCostMap {
    /// The grid inside.
    pub(in crate::c_abi) fn grid(&self) -> &Grid {
        each!(self, map => map.occupancy_grid())
    }
}

/// The buffers of a map with a field of `F`.
pub(in crate::c_abi) struct Buffers<F: FieldCell> {
    /// One, or none when only measured.
    tables: &'static mut [CostTables<F>],
    scratch: &'static mut [u32],
    bits: &'static mut [u32],
    field: &'static mut [F],
    cells: &'static mut [i8],
    costs: Option<&'static mut [u8]>,
}

/// The buffers of either map.
pub(in crate::c_abi) enum AnyBuffers {
    OneByte(Buffers<u8>),
    TwoBytes(Buffers<u16>),
}

impl<F: FieldCell + Zeroed> Buffers<F> {
    /// The most aligned first, so that nothing lies between them.
    fn take(config: &horus_cost_map_config, scratch: usize, arena: &mut Arena) -> Result<Self, horus_status> {
        let cells = config.grid.cells()?;
        config.params.params()?.validate()?;
        Ok(Self {
            tables: arena.take(1)?,
            scratch: arena.take(scratch)?,
            bits: arena.take(bit_words(config.grid.width, config.grid.height))?,
            field: arena.take(cells)?,
            cells: arena.take(cells)?,
            costs: match config.keep_costs {
                0 => None,
                _ => Some(arena.take(cells)?),
            },
        })
    }

    fn map(self, config: &horus_cost_map_config) -> Result<CostMap<'static, F>, horus_status> {
        let grid = config.grid.grid(self.cells)?;
        let buffers = CostBuffers {
            bits: self.bits,
            field: self.field,
            scratch: self.scratch,
            costs: self.costs,
            tables: self.tables.first_mut().ok_or(horus_status::BufferTooSmall)?,
        };
        Ok(CostMap::new_in(grid, buffers, config.params.params()?)?)
    }
}

impl Object for AnyCostMap {
    const TAG: u32 = u32::from_le_bytes(*b"HCm1");
    type Handle = horus_cost_map;
    type Config = horus_cost_map_config;
    type Buffers = AnyBuffers;

    fn buffers(config: &Self::Config, arena: &mut Arena) -> Result<Self::Buffers, horus_status> {
        match config.field_bytes {
            1 => Ok(AnyBuffers::OneByte(Buffers::take(config, SCRATCH_1, arena)?)),
            2 => Ok(AnyBuffers::TwoBytes(Buffers::take(config, SCRATCH_2, arena)?)),
            _ => Err(horus_status::InvalidChoice),
        }
    }

    fn new(config: &Self::Config, buffers: Self::Buffers) -> Result<Self, horus_status> {
        match buffers {
            AnyBuffers::OneByte(buffers) => Ok(Self::OneByte(buffers.map(config)?)),
            AnyBuffers::TwoBytes(buffers) => Ok(Self::TwoBytes(buffers.map(config)?)),
        }
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
        claims.output(bytes)?.write(object::bytes::<AnyCostMap>(&config)?);
        Ok(())
    })
}

/// Makes a cost map of unknown cells in `length` bytes of memory and computes its costs.
///
/// Fails as horus_cost_map_bytes does, and with HORUS_STATUS_BUFFER_TOO_SMALL; with
/// HORUS_STATUS_RADIUS_TOO_LARGE the memory holds no object.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_cost_map_init(
    memory: *mut c_void,
    length: usize,
    config: *const horus_cost_map_config,
    map: *mut *mut horus_cost_map,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| object::init::<AnyCostMap>(claims, memory, length, config, map))
}
