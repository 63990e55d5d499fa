//! Sequences of cost map operations with the one-byte field, core against the std version.
#![no_main]
use horus_fuzz::costmap::{CostCase, run};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|case: CostCase| run::<u8>(&case));
