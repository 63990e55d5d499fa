//! Arbitrary, built and damaged MCAP logs: an error or messages, in bounded memory.
#![no_main]
use horus_fuzz::mcap_reader::{ReaderCase, run};
use horus_fuzz::memory::Counting;
use libfuzzer_sys::fuzz_target;

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fuzz_target!(|case: ReaderCase| run(&case));
