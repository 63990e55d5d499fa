//! How deep a call reaches into the stack: the free part is painted before the call, and what has
//! lost its paint afterwards was used.

#[cfg(target_os = "none")]
mod painter {
    /// Bytes below the present frame that are painted; a deeper call shows as this many.
    const WINDOW: usize = 8 * 1024;
    const COLOUR: u32 = 0xa5c3_965a;

    unsafe extern "C" {
        /// First address after all statics, from the linker script.
        #[link_name = "__sheap"]
        static END_OF_STATICS: u32;
    }

    /// A painted stretch of stack, up to the stack pointer of the function that painted it.
    pub struct Paint {
        start: usize,
        end: usize,
    }

    impl Paint {
        /// Paints below the frame of the caller, into which it is inlined: nothing there may use
        /// the stack before the call that is measured.
        #[inline(always)]
        pub fn new() -> Self {
            let end = cortex_m::register::msp::read() as usize;
            let start = (end - WINDOW).max((&raw const END_OF_STATICS) as usize);
            for at in (start..end).step_by(4) {
                // SAFETY: aligned, above the statics and below every live frame.
                unsafe { (at as *mut u32).write_volatile(COLOUR) }
            }
            Self { start, end }
        }

        /// Bytes that are painted.
        pub fn size(&self) -> u32 {
            (self.end - self.start) as u32
        }

        /// Bytes from the deepest word without paint up to the painter's frame.
        #[inline(always)]
        pub fn used(&self) -> u32 {
            let mut at = self.start;
            // SAFETY: as above.
            while at < self.end && unsafe { (at as *const u32).read_volatile() } == COLOUR {
                at += 4;
            }
            (self.end - at) as u32
        }
    }
}

#[cfg(not(target_os = "none"))]
mod painter {
    pub struct Paint;

    impl Paint {
        pub fn new() -> Self {
            Self
        }

        pub fn size(&self) -> u32 {
            0
        }

        pub fn used(&self) -> u32 {
            0
        }
    }
}

pub(super) use painter::Paint;
