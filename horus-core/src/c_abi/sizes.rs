//! What the header's macros for static memory are made of, held to the objects they stand for.

use super::cost_map::AnyCostMap;
use super::distance::AnyDistanceMap;
use super::evidence::{HORUS_LOCAL_MAPPING_INPAINTS, HORUS_LOCAL_MAPPING_SENSORS, Mapping};
use super::grid::Grid;
use super::local_map::{HORUS_LOCAL_MAP_LIDARS, HORUS_LOCAL_MAP_NAME, LocalMap};
use super::object::Placed;
use super::scan::Workspace;
use crate::costmap::{CostMap, CostTables, FieldCell, scratch_words};
use crate::distance::DistanceMap;
use crate::evidence::{Inpaint, SensorConfig};
use crate::local::BufferSlot;

/// Alignment, in bytes, of the memory given to every init.
pub const HORUS_ALIGN: usize = 8;

/// Bytes of a grid besides its cells.
#[cfg(target_pointer_width = "64")]
pub const HORUS_GRID_FIXED_BYTES: usize = 192;
/// Bytes of a grid besides its cells.
#[cfg(target_pointer_width = "32")]
pub const HORUS_GRID_FIXED_BYTES: usize = 176;

/// Bytes of a scan workspace besides its beams and cells.
#[cfg(target_pointer_width = "64")]
pub const HORUS_SCAN_WORKSPACE_FIXED_BYTES: usize = 80;
/// Bytes of a scan workspace besides its beams and cells.
#[cfg(target_pointer_width = "32")]
pub const HORUS_SCAN_WORKSPACE_FIXED_BYTES: usize = 48;

/// Bytes of a cost map with a one-byte field besides its cells.
#[cfg(target_pointer_width = "64")]
pub const HORUS_COST_MAP_1_FIXED_BYTES: usize = 4032;
/// Bytes of a cost map with a one-byte field besides its cells.
#[cfg(target_pointer_width = "32")]
pub const HORUS_COST_MAP_1_FIXED_BYTES: usize = 3936;

/// Bytes of a cost map with a two-byte field besides its cells.
#[cfg(target_pointer_width = "64")]
pub const HORUS_COST_MAP_2_FIXED_BYTES: usize = 11976;
/// Bytes of a cost map with a two-byte field besides its cells.
#[cfg(target_pointer_width = "32")]
pub const HORUS_COST_MAP_2_FIXED_BYTES: usize = 9832;

/// Bytes of a distance map besides its cells and columns.
#[cfg(target_pointer_width = "64")]
pub const HORUS_DISTANCE_MAP_FIXED_BYTES: usize = 176;
/// Bytes of a distance map besides its cells and columns.
#[cfg(target_pointer_width = "32")]
pub const HORUS_DISTANCE_MAP_FIXED_BYTES: usize = 128;

/// Bytes of a local map besides its cells and its lidars' beams.
#[cfg(target_pointer_width = "64")]
pub const HORUS_LOCAL_MAP_FIXED_BYTES: usize = 3328;
/// Bytes of a local map besides its cells and its lidars' beams.
#[cfg(target_pointer_width = "32")]
pub const HORUS_LOCAL_MAP_FIXED_BYTES: usize = 2816;

/// Bytes of a local mapping besides its cells, beams and columns.
#[cfg(target_pointer_width = "64")]
pub const HORUS_LOCAL_MAPPING_FIXED_BYTES: usize = 1280;
/// Bytes of a local mapping besides its cells, beams and columns.
#[cfg(target_pointer_width = "32")]
pub const HORUS_LOCAL_MAPPING_FIXED_BYTES: usize = 1088;

// A constant that fails here is to be raised, and the header written anew.
const _: () = {
    assert!(size_of::<Placed<Grid>>() <= HORUS_GRID_FIXED_BYTES);
    assert!(size_of::<Placed<Workspace>>() <= HORUS_SCAN_WORKSPACE_FIXED_BYTES);
    assert!(local_mapping() <= HORUS_LOCAL_MAPPING_FIXED_BYTES);
    assert!(cost_map::<u8>(15) <= HORUS_COST_MAP_1_FIXED_BYTES);
    assert!(cost_map::<u16>(31) <= HORUS_COST_MAP_2_FIXED_BYTES);
    assert!(distance_map() <= HORUS_DISTANCE_MAP_FIXED_BYTES);
    assert!(LOCAL_MAP <= HORUS_LOCAL_MAP_FIXED_BYTES);
};

/// What a distance map takes besides its cells and columns.
const fn distance_map() -> usize {
    let handle = size_of::<Placed<AnyDistanceMap>>().next_multiple_of(HORUS_ALIGN);
    handle + size_of::<DistanceMap<'static, i32>>()
}

/// What a cost map takes besides its cells, with scratch memory for this radius.
const fn cost_map<F: FieldCell>(radius: u32) -> usize {
    let handle = size_of::<Placed<AnyCostMap>>().next_multiple_of(HORUS_ALIGN);
    let object = handle + size_of::<CostMap<'static, F>>();
    object + size_of::<CostTables<F>>() + size_of::<u32>() * scratch_words(radius)
}

/// What a local map takes besides its cells, and 24 bytes per lidar and 16 per beam.
const LOCAL_MAP: usize = {
    let object = size_of::<Placed<LocalMap>>().next_multiple_of(HORUS_ALIGN);
    let names =
        size_of::<&str>() * HORUS_LOCAL_MAP_LIDARS + HORUS_LOCAL_MAP_NAME * (2 + HORUS_LOCAL_MAP_LIDARS);
    object + names + size_of::<BufferSlot>() * (5 * HORUS_LOCAL_MAP_LIDARS + 6) + size_of::<f32>() * 12
};
/// What a local mapping takes besides its buffers.
const fn local_mapping() -> usize {
    let object = size_of::<Placed<Mapping>>().next_multiple_of(HORUS_ALIGN);
    let sensors = size_of::<[SensorConfig; HORUS_LOCAL_MAPPING_SENSORS]>();
    object + sensors + size_of::<[Inpaint; HORUS_LOCAL_MAPPING_INPAINTS]>()
}
