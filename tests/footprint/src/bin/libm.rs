//! The float functions that core calls, all of them, without core.
#![no_std]
#![no_main]

use horus_footprint::{need, opaque};

horus_footprint::start!(run);

fn run() {
    let (x, y, z) = (opaque(1.5f32), opaque(2.5f32), opaque(3.5f64));
    need([libm::ceilf(x), libm::rintf(x), libm::sqrtf(x), libm::powf(x, y)]);
    need(libm::expf(x));
    need((libm::sincosf(x), libm::sincos(z)));
}
