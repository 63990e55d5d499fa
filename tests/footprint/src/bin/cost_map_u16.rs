//! The same with a two-byte field.
#![no_std]
#![no_main]

use horus_footprint::robot;

horus_footprint::start!(run);
horus_footprint::run_cost_map!(robot::drive, 160, u16, 2048, 0);
