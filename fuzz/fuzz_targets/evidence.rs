//! Scans into local mapping, core against the std version.
#![no_main]
use horus_fuzz::evidence::{EvidenceCase, run};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|case: EvidenceCase| run(&case));
