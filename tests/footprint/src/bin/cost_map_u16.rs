//! The same with a two-byte field.
#![no_std]
#![no_main]

use horus_core::costmap::bit_words;
use horus_core::prelude::*;
use horus_footprint::{in_bss, need, opaque, robot};

horus_footprint::start!(run);

/// All that the map takes.
type Storage = CostMapBuffers<{ 160 * 160 }, { bit_words(160, 160) }, u16, 2048>;

fn run() {
    let storage = in_bss!(Storage, Storage::empty());
    let beams = in_bss!(ScanBuffers<360, 0>, ScanBuffers::empty());
    let ranges = opaque(in_bss!([f32; 360], [0.0; 360]));
    need(robot::drive(
        storage.split(),
        &mut beams.workspace(),
        ranges,
        opaque(160),
    ));
}
