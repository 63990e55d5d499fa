//! Vector table and reset handler alone: what the other images are compared with.
#![no_std]
#![no_main]

horus_footprint::start!(run);

fn run() {}
