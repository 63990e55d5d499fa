//! Streams of frames: arbitrary bytes, sound frames with arbitrary contents, maps there and back.
#![no_main]
use horus_fuzz::frames::{FramesCase, run};
use horus_fuzz::memory::Counting;
use libfuzzer_sys::fuzz_target;

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fuzz_target!(|case: FramesCase| run(&case));
