//! Calls every public function of core on inputs that the optimiser knows nothing about. It links
//! only if none of them can panic.
//!
//! `tests/host/footprint` checks that every `pub fn` of core is named here. Left out are `Debug`
//! and `Display`, which are core::fmt's.
#![no_std]
#![no_main]

mod cost_map;
mod distance;
mod evidence;
mod frames;
#[cfg(feature = "c-abi")]
mod from_c;
mod geometry;
mod grid;
mod local;
#[cfg(feature = "defmt")]
mod logged;
mod requirements;
#[cfg(feature = "serde")]
mod serialised;

use horus_core::costmap::{CostMapBuffers, bit_words};
use horus_core::prelude::*;
use horus_footprint::{in_bss, opaque};

horus_footprint::start!(run);

/// Cells per side.
const SIDE: u32 = 64;
const CELLS: usize = (SIDE * SIDE) as usize;
const BITS: usize = bit_words(SIDE, SIDE);

fn run() {
    let near = in_bss!(CostMapBuffers<CELLS, BITS>, CostMapBuffers::<CELLS, BITS>::empty());
    let far = in_bss!(
        CostMapBuffers<CELLS, BITS, u16, 2048>,
        CostMapBuffers::<CELLS, BITS, u16, 2048>::empty()
    );
    let costs = in_bss!([u8; CELLS], [0; CELLS]);
    let grid = in_bss!(StaticOccupancyGrid<CELLS>, StaticOccupancyGrid::empty());
    let beams = in_bss!(ScanBuffers<360, { CELLS / 32 }>, ScanBuffers::empty());
    let ranges = &*opaque(in_bss!([f32; 360], [0.0; 360]));
    let mut workspace = beams.workspace();

    geometry::call();
    grid::call(grid, ranges, &mut workspace);
    grid::view(opaque(grid.data()));
    requirements::call(opaque(grid));
    distance::call(opaque(grid));
    let (cells, mut buffers) = near.split();
    buffers.costs = opaque(Some(&mut costs[..]));
    let frame = opaque(in_bss!([u8; 512], [0; 512]));
    cost_map::call((opaque(cells), buffers), ranges, &mut workspace, frame);
    let (cells, buffers) = far.split();
    cost_map::call((opaque(cells), buffers), ranges, &mut workspace, frame);
    frames::read(frame, opaque(&mut [0; 12]));
    cost_map::tables();
    let map = in_bss!([u8; CELLS], [0; CELLS]);
    local::call(opaque(map), ranges);
    evidence::call(opaque(ranges));
    #[cfg(feature = "c-abi")]
    from_c::call();
    #[cfg(feature = "defmt")]
    logged::call();
    #[cfg(feature = "serde")]
    serialised::call();
    #[cfg(feature = "mutant")]
    horus_footprint::need([1u8, 2, 3][opaque(4usize)]);
}
