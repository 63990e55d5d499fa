//! The same with both scan models.
#![no_std]
#![no_main]

use horus_core::prelude::ScanModel;

horus_footprint::start!(run);
horus_footprint::run_scans!(opaque(ScanModel::Set), 1250);
