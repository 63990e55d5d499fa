//! A counter of executed instructions: QEMU's STM32F405 started with `-icount shift=0` advances
//! its timers by one nanosecond per instruction, and TIM2 counts nanoseconds, all 32 bits of them.

#[cfg(target_os = "none")]
mod timer {
    const TIM2_CR1: *mut u32 = 0x4000_0000 as *mut u32;
    const TIM2_CNT: *const u32 = 0x4000_0024 as *const u32;
    const ENABLE: u32 = 1;

    pub fn start() {
        // SAFETY: a device register of the machine these programs run on.
        unsafe { TIM2_CR1.write_volatile(ENABLE) }
    }

    #[inline(always)]
    pub fn now() -> u32 {
        // SAFETY: as above.
        unsafe { TIM2_CNT.read_volatile() }
    }
}

#[cfg(not(target_os = "none"))]
mod timer {
    pub fn start() {}

    pub fn now() -> u32 {
        0
    }
}

pub(super) use timer::{now, start};
