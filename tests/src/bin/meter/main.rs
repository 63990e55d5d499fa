//! Prints what every operation takes on the target: instructions and bytes of stack.
//!
//! `tests/meter` runs it in QEMU and compares the table with the committed one. Another capability
//! adds a module with a `run` of its own, a call in [`all`], and perhaps lines in `targets.rs`.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod bench;
mod case;
mod cost_map;
mod distance;
mod grid;
mod local;
mod occupied;
mod rays;
mod targets;
mod tick;

use bench::Bench;
use horus_core::costmap::{CostMapBuffers, bit_words};
use horus_tests::meter::{Meter, Table};
use horus_tests::rt::hprintln;
use horus_tests::{Arena, Once};

#[cfg(target_os = "none")]
horus_tests::start!(run);

#[cfg(not(target_os = "none"))]
fn main() {
    let counted = run();
    std::process::exit(if counted { 0 } else { 2 });
}

fn run() -> bool {
    let Some(meter) = Meter::start() else {
        hprintln!("meter: nothing can be counted here: run it on the target, with tests/meter");
        return false;
    };
    let mut table = Table::new(&targets::TARGETS);
    if let Err(error) = all(&mut Bench::new(meter, &mut table)) {
        hprintln!("meter: {}", error);
        return false;
    }
    table.finish()
}

/// The largest map, 200 x 200 cells with a one-byte field; the others take its place in turn.
type Near = CostMapBuffers<{ 200 * 200 }, { bit_words(200, 200) }>;
/// With kept cost bytes.
type Kept = (
    CostMapBuffers<{ 160 * 160 }, { bit_words(160, 160) }>,
    [u8; 160 * 160],
);
/// With a two-byte field up to 31 cells.
type Middle = CostMapBuffers<{ 160 * 160 }, { bit_words(160, 160) }, u16, 2048>;
/// Beyond.
type Far = CostMapBuffers<{ 100 * 100 }, { bit_words(100, 100) }, u16, 512>;

fn all(bench: &mut Bench<'_>) -> Result<(), horus_core::Error> {
    static ARENA: Once<Arena<{ size_of::<Near>() }>> = Once::new(Arena::new());
    // SAFETY: this function runs once.
    let arena = unsafe { ARENA.take() };

    grid::run(arena.zeroed::<[i8; 200 * 200]>(), bench)?;
    let (cells, state) = arena.zeroed::<([u8; 200 * 200], local::State)>();
    local::run((cells, state), bench)?;
    local::run_dense(arena.zeroed(), bench)?;
    local::run_followed(arena.zeroed(), bench)?;
    for case in [case::R11, case::R15] {
        cost_map::run(&case, arena.zeroed::<Near>().split(), bench)?;
        tick::run(&case, arena.zeroed::<Near>().split(), bench)?;
    }
    let (buffers, costs) = arena.zeroed::<Kept>();
    let (cells, mut buffers) = buffers.split();
    buffers.costs = Some(costs);
    cost_map::run(&case::R11_KEPT, (cells, buffers), bench)?;
    cost_map::run(&case::R20, arena.zeroed::<Middle>().split(), bench)?;
    tick::run(&case::R20, arena.zeroed::<Middle>().split(), bench)?;
    cost_map::run(&case::R40, arena.zeroed::<Far>().split(), bench)?;
    rays::run(arena.zeroed::<[i8; 200 * 200]>(), bench)?;
    distance::run::<u16>("128x128 u16", arena.zeroed(), bench)?;
    distance::run::<i16>("128x128 i16, signed", arena.zeroed(), bench)?;
    distance::run::<u32>("128x128 u32", arena.zeroed(), bench)
}
