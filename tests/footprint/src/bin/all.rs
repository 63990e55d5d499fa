//! The same with a one-byte field and every operation that a cost map has.
#![no_std]
#![no_main]

use horus_core::costmap::bit_words;
use horus_core::prelude::*;
use horus_footprint::{in_bss, need, opaque, robot};

horus_footprint::start!(run);

/// All that the map takes.
type Storage = CostMapBuffers<{ 200 * 200 }, { bit_words(200, 200) }>;

fn run() {
    let storage = in_bss!(Storage, Storage::empty());
    let beams = in_bss!(ScanBuffers<360, 1250>, ScanBuffers::empty());
    let ranges = opaque(in_bss!([f32; 360], [0.0; 360]));
    need(robot::use_all(
        storage.split(),
        &mut beams.workspace(),
        ranges,
        opaque(200),
    ));
}
