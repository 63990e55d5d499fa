//! Sequences of grid operations, core against the std version.
#![no_main]
use horus_fuzz::grid::{GridCase, run};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|case: GridCase| run(&case));
