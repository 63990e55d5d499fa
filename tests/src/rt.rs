//! Start, print and exit, on the host and on the target.

#[cfg(target_os = "none")]
mod target {
    pub use cortex_m as _; // links the critical section that semihosting needs
    pub use cortex_m_semihosting::hprintln;

    use cortex_m_semihosting::debug;

    /// Ends the program; QEMU's exit code tells whether it succeeded.
    pub fn exit(ok: bool) -> ! {
        debug::exit(if ok {
            debug::EXIT_SUCCESS
        } else {
            debug::EXIT_FAILURE
        });
        loop {
            cortex_m::asm::nop();
        }
    }

    /// Without it the default handler spins and QEMU ends only by its time limit.
    #[cortex_m_rt::exception]
    unsafe fn HardFault(frame: &cortex_m_rt::ExceptionFrame) -> ! {
        hprintln!("HardFault at {:#010x}", frame.pc());
        exit(false)
    }

    #[panic_handler]
    fn panic(info: &core::panic::PanicInfo<'_>) -> ! {
        hprintln!("{}", info);
        exit(false)
    }
}

#[cfg(target_os = "none")]
pub use target::{exit, hprintln};

#[cfg(not(target_os = "none"))]
extern crate std;

#[cfg(not(target_os = "none"))]
pub use std::println as hprintln;

/// Ends the program; the exit code tells whether it succeeded.
#[cfg(not(target_os = "none"))]
pub fn exit(ok: bool) -> ! {
    std::process::exit(if ok { 0 } else { 1 })
}

/// Declares the program's start: `start!(run)` where `fn run() -> bool`.
#[macro_export]
macro_rules! start {
    ($run:path) => {
        #[cfg(target_os = "none")]
        #[unsafe(no_mangle)]
        extern "C" fn main() -> ! {
            // The reset handler of cortex-m-rt calls the symbol `main`.
            $crate::rt::exit($run())
        }
        #[cfg(not(target_os = "none"))]
        fn main() {
            $crate::rt::exit($run())
        }
    };
}
