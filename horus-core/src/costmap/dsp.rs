//! Arithmetic on the four bytes of a word at once, with the DSP instructions of Cortex-M4, M7 and
//! M33; in plain code for the tests on other machines.
#![cfg_attr(target_arch = "arm", allow(unsafe_code))]

/// Sums of bytes, at most 255.
#[cfg(target_arch = "arm")]
#[inline(always)]
pub(super) fn add(a: u32, b: u32) -> u32 {
    let sum;
    // SAFETY: one instruction on registers: no memory, no stack, no flags.
    unsafe {
        core::arch::asm!("uqadd8 {}, {}, {}", lateout(reg) sum, in(reg) a, in(reg) b,
            options(pure, nomem, nostack, preserves_flags));
    }
    sum
}

/// Differences of bytes, wrapping.
#[cfg(target_arch = "arm")]
#[inline(always)]
pub(super) fn subtract(a: u32, b: u32) -> u32 {
    let difference;
    // SAFETY: one instruction on registers: no memory, no stack; it sets the GE flags, which
    // nothing reads before they are set again.
    unsafe {
        core::arch::asm!("usub8 {}, {}, {}", lateout(reg) difference, in(reg) a, in(reg) b,
            options(pure, nomem, nostack));
    }
    difference
}

/// Takes each byte of `then` where that of `value` is at least that of `limit`, else of `other`.
#[cfg(target_arch = "arm")]
#[inline(always)]
pub(super) fn select(value: u32, limit: u32, then: u32, other: u32) -> u32 {
    let chosen;
    // SAFETY: two instructions on registers: no memory, no stack. The first sets the GE flags,
    // which only the second reads.
    unsafe {
        core::arch::asm!("usub8 {chosen}, {value}, {limit}", "sel {chosen}, {then}, {other}",
            chosen = out(reg) chosen, value = in(reg) value, limit = in(reg) limit,
            then = in(reg) then, other = in(reg) other, options(pure, nomem, nostack));
    }
    chosen
}

#[cfg(not(target_arch = "arm"))]
fn each(f: impl Fn(usize) -> u8) -> u32 {
    u32::from_le_bytes(core::array::from_fn(f))
}

/// As on the target.
#[cfg(not(target_arch = "arm"))]
pub(super) fn add(a: u32, b: u32) -> u32 {
    let (a, b) = (a.to_le_bytes(), b.to_le_bytes());
    each(|i| a[i].saturating_add(b[i]))
}

/// As on the target.
#[cfg(not(target_arch = "arm"))]
pub(super) fn select(value: u32, limit: u32, then: u32, other: u32) -> u32 {
    let [value, limit, then, other] = [value, limit, then, other].map(u32::to_le_bytes);
    each(|i| if value[i] >= limit[i] { then[i] } else { other[i] })
}

/// The lesser of each two bytes.
#[inline(always)]
pub(super) fn min(a: u32, b: u32) -> u32 {
    select(a, b, b, a)
}
