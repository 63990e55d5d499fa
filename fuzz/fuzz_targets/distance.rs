//! Distances, walks and rays, core against the std version.
#![no_main]
use horus_fuzz::distance::{DistanceCase, run};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|case: DistanceCase| run(&case));
