//! Input that C programs make up in the same way, to the bit (`tests/c`).

/// The next number of a sequence, 24 bits.
pub fn next(noise: &mut u32) -> u32 {
    *noise ^= *noise << 13;
    *noise ^= *noise >> 17;
    *noise ^= *noise << 5;
    *noise >> 8
}

/// Metres from millimetres: the one rounding of the input.
pub fn metres(mm: i32) -> f32 {
    mm as f32 * 0.001
}
