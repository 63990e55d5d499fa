//! Start, print, send and exit, on the host and on the target.

#[cfg(target_os = "none")]
mod target {
    pub use cortex_m as _; // links the critical section that semihosting needs
    pub use cortex_m_semihosting::hprintln;
    /// Prints beside what is [sent](send).
    pub use cortex_m_semihosting::hprintln as note;

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

    /// USART1 of an STM32F405: status, data, and the first control register.
    const USART_SR: *mut u32 = 0x4001_1000 as *mut u32;
    const USART_DR: *mut u32 = 0x4001_1004 as *mut u32;
    const USART_CR1: *mut u32 = 0x4001_100c as *mut u32;
    /// Room for a byte; enable, and enable sending.
    const TXE: u32 = 1 << 7;
    const UE_TE: u32 = 1 << 13 | 1 << 3;

    /// Sends bytes over USART1. Clock, pins and speed are as they are: QEMU needs none of them.
    pub fn send(bytes: &[u8]) {
        // SAFETY: registers of a peripheral that nobody else uses.
        unsafe {
            USART_CR1.write_volatile(UE_TE);
            for byte in bytes {
                while USART_SR.read_volatile() & TXE == 0 {}
                USART_DR.write_volatile(u32::from(*byte));
            }
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
pub use target::{exit, hprintln, note, send};

#[cfg(not(target_os = "none"))]
extern crate std;

#[cfg(not(target_os = "none"))]
pub use std::{eprintln as note, println as hprintln};

/// Sends bytes to standard output; the program ends if that takes none.
#[cfg(not(target_os = "none"))]
pub fn send(bytes: &[u8]) {
    use std::io::Write;
    if std::io::stdout().write_all(bytes).is_err() {
        exit(false);
    }
}

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
