//! The one panic handler an image must have, for C firmware that brings no other Rust.

use core::panic::PanicInfo;

unsafe extern "C" {
    /// The firmware's: called when the library finds a defect of its own, which no input is known to
    /// bring about. Must not return.
    safe fn horus_panic() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    horus_panic()
}
