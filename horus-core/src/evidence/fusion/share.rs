//! PCR6's division of a conflict between its two parties, exactly.

/// floor(p^2 q / (p + q)) for p, q <= 65535, 0 if both are 0: the share of p in the conflict p q.
///
/// With 32-bit multiplications and two divisions, which a Cortex-M4 has instructions for.
///
/// With s = p + q and p q = a s + r, r the remainder of least size, |r| <= s / 2 <= 65535, the share
/// is p a + p r / s, where |p r| and what rounding adds still fit into 32 bits.
#[inline(always)]
pub(super) fn in_words(p: u32, q: u32) -> u32 {
    let conflict = p.wrapping_mul(q);
    if conflict == 0 {
        return 0;
    }
    let sum = p.wrapping_add(q);
    let nearest = conflict.wrapping_add(sum >> 1).checked_div(sum).unwrap_or(0);
    let rest = conflict.wrapping_sub(nearest.wrapping_mul(sum)) as i32;
    let whole = p.wrapping_mul(nearest);
    let part = p.wrapping_mul(rest.unsigned_abs());
    if rest >= 0 {
        whole.wrapping_add(part.checked_div(sum).unwrap_or(0))
    } else {
        // Rounded up before it is taken away: at most 65535^2 + 131069, which is below 2^32.
        whole.wrapping_sub(
            part.wrapping_add(sum.wrapping_sub(1))
                .checked_div(sum)
                .unwrap_or(0),
        )
    }
}

/// In f64 without branches, for several cells, which a compiler makes vectors of. No 64-bit host is
/// without f64.
///
/// p^2 q < 2^48 is exact, and the rounded quotient x is within 2^-22 of the true one. That is a
/// multiple of 1 / s, s < 2^17, so that adding -1/2 + 2^-18 makes the nearest integer the floor, and
/// adding 1.5 * 2^52, around which floats are one apart, leaves that integer in the low bits. A
/// sum of 0 becomes 1: 0 / 1.
#[inline(always)]
pub(super) fn in_floats<const N: usize>(p: &[u32; N], q: &[u32; N]) -> [u32; N] {
    const FLOOR: f64 = 0.5 - 1.0 / 262_144.0;
    const LOW_BITS: f64 = 6_755_399_441_055_744.0;
    let mut quotients = [0.0; N];
    for i in 0..N {
        let (p, q) = (f64::from(p[i] as i32), f64::from(q[i] as i32));
        let sum = p + q;
        quotients[i] = p * p * q / if sum > 1.0 { sum } else { 1.0 };
    }
    quotients.map(|quotient| ((quotient - FLOOR) + LOW_BITS).to_bits() as u32)
}

#[cfg(test)]
mod tests {
    use super::{in_floats, in_words};

    fn literal(p: u32, q: u32) -> u32 {
        let (p, q) = (u64::from(p), u64::from(q));
        (p * p * q).checked_div(p + q).unwrap_or(0) as u32
    }

    fn check(p: u32, q: u32) {
        assert_eq!(in_words(p, q), literal(p, q), "{p} {q}");
        assert_eq!(in_floats(&[p], &[q]), [literal(p, q)], "{p} {q}");
    }

    #[test]
    fn both_ways_are_exact() {
        for p in 0..=600 {
            for q in 0..=600 {
                check(p, q);
            }
        }
        // Both ends, and a grid of prime strides.
        let values = || (0..=65_535u32).filter(|v| v % 97 == 0 || *v < 40 || *v > 65_500);
        for p in values() {
            for q in values() {
                check(p, q);
            }
        }
    }
}
