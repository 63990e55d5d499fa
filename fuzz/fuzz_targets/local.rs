//! Drives of a local map, core against the std version.
#![no_main]
use horus_fuzz::local::{LocalCase, run};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|case: LocalCase| run(&case));
