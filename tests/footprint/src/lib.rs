//! What the programs of this package stand on: a start, and a panic handler that cannot be linked.
#![no_std]

pub mod robot;

use core::panic::PanicInfo;

use cortex_m_rt as _; // the vector table and the reset handler, which calls `main`

unsafe extern "C" {
    /// Defined nowhere: the linker names it when a panic can be reached.
    fn this_program_can_panic() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    // SAFETY: never linked, so never called.
    unsafe { this_program_can_panic() }
}

/// A value about which the optimiser knows nothing.
#[inline(always)]
pub fn opaque<T>(value: T) -> T {
    core::hint::black_box(value)
}

/// Makes a value, and all that leads to it, needed.
#[inline(always)]
pub fn need<T>(value: T) {
    core::hint::black_box(value);
}

/// Declares the program's start: `start!(run)` where `fn run()`.
#[macro_export]
macro_rules! start {
    ($run:path) => {
        #[unsafe(no_mangle)]
        extern "C" fn main() -> ! {
            $run();
            loop {
                core::hint::spin_loop();
            }
        }
    };
}

/// A static of this type and value, all bits zero, borrowed mutably; to be used once per place.
#[macro_export]
macro_rules! in_bss {
    ($type:ty, $empty:expr) => {{
        static mut STORAGE: $type = $empty;
        // SAFETY: one thread, and `run` runs once.
        unsafe { &mut *(&raw mut STORAGE) }
    }};
}
