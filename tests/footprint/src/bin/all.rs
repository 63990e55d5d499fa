//! The same with a one-byte field and every operation that a cost map has.
#![no_std]
#![no_main]

use horus_footprint::robot;

horus_footprint::start!(run);
horus_footprint::run_cost_map!(robot::use_all, 200, u8, 512, 1250);
