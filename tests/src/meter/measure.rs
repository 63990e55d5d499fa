use core::hint::black_box;
use core::sync::atomic::{Ordering, compiler_fence};

use super::stack::Paint;
use super::{Cost, Table, clock};

/// Measures calls; knows what measuring nothing shows, and subtracts it.
#[derive(Clone, Copy, Debug)]
pub struct Meter {
    nothing: Cost,
}

impl Meter {
    /// Starts the clock. `None` where nothing can be measured: on the host, and with so little
    /// free RAM that a stack beyond the limit would not be seen.
    pub fn start() -> Option<Self> {
        clock::start();
        let (_, nothing) = raw(|| ());
        let enough = 2 * Table::STACK_LIMIT;
        (Paint::new().size() >= enough).then_some(Self { nothing })
    }

    /// Calls `operation` once: its result and what it took. Nothing about the values that the
    /// closure holds is known to the optimiser.
    pub fn measure<R>(&self, operation: impl FnOnce() -> R) -> (R, Cost) {
        let (result, Cost { instructions, stack }) = raw(operation);
        let cost = Cost {
            instructions: instructions.saturating_sub(self.nothing.instructions),
            stack: stack.saturating_sub(self.nothing.stack),
        };
        (result, cost)
    }
}

#[inline(never)]
fn raw<R>(operation: impl FnOnce() -> R) -> (R, Cost) {
    let paint = Paint::new();
    let (result, instructions) = timed(operation);
    let stack = paint.used();
    (result, Cost { instructions, stack })
}

/// A frame of its own, so that all the operation's stack lies below its caller's frame.
#[inline(never)]
fn timed<R>(operation: impl FnOnce() -> R) -> (R, u32) {
    let operation = black_box(operation);
    compiler_fence(Ordering::SeqCst);
    let start = clock::now();
    let result = black_box(operation());
    compiler_fence(Ordering::SeqCst);
    let end = clock::now();
    (result, end.wrapping_sub(start))
}
