//! Rolling grid, scans (`Set`) and cost map with a one-byte field, as in the README's firmware.
#![no_std]
#![no_main]

use horus_footprint::robot;

horus_footprint::start!(run);
horus_footprint::run_cost_map!(robot::drive, 200, u8, 512, 0);
