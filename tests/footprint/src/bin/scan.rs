//! The rolling occupancy grid with scan integration (`Set`).
#![no_std]
#![no_main]

use horus_core::prelude::ScanModel;

horus_footprint::start!(run);
horus_footprint::run_scans!(ScanModel::Set, 0);
