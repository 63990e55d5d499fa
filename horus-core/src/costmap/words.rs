//! Rows of one-byte field cells four at a time, in 32-bit words: what a core without vector
//! instructions does fastest in portable code.

use core::hint::cold_path;

use super::kernel::stamp::{FEW_LANES, LANES};

/// Cells per word.
const CELLS: usize = 4;
type Word = [u8; CELLS];
/// The highest bit of every cell.
const HIGH: u32 = every(0x80);

/// The same byte in every cell.
pub(super) const fn every(byte: u8) -> u32 {
    byte as u32 * 0x0101_0101
}

/// All bits of the cells whose highest bit is set in `high`, which has no other bits.
#[inline(always)]
fn spread(high: u32) -> u32 {
    (high - (high >> 7)) | high
}

/// The highest bit of every cell that is zero.
#[inline(always)]
fn zeros(word: u32) -> u32 {
    !(((word & !HIGH) + !HIGH) | word) & HIGH
}

/// What stands for a column that is to stay as it is in a narrow disc.
pub(super) const NO_SQUARE: u8 = 128;

/// Lowers each cell to the square of its column. With [`FEW_LANES`], cells are below 128 or 255,
/// squares below 128 or [`NO_SQUARE`].
#[inline(always)]
pub(super) fn lower<const N: usize>(row: &mut [u8; N], squares: &[u8; N]) {
    if N == FEW_LANES {
        over(row, squares, lesser::<false>);
    } else {
        over(row, squares, lesser::<true>);
    }
}

/// The lesser of each two cells, where any is less than `old`.
#[cfg(all(feature = "dsp", target_arch = "arm"))]
#[inline(always)]
fn lesser<const WIDE: bool>(old: u32, new: u32) -> Option<u32> {
    Some(super::dsp::min(old, new))
}

/// The lesser of each two cells; `None` if all of `old` are less.
#[cfg(not(all(feature = "dsp", target_arch = "arm")))]
#[inline(always)]
fn lesser<const WIDE: bool>(old: u32, new: u32) -> Option<u32> {
    // The highest bit of every cell where old >= new: borrows never leave a cell.
    let at_least = if WIDE {
        let low = (old | HIGH) - (new & !HIGH);
        (old & !new) | (!(old ^ new) & low)
    } else {
        // Nothing borrows: 255 - 128 has no highest bit, 255 - 127 has.
        (old | HIGH) - new
    };
    if at_least & HIGH == 0 {
        return None;
    }
    cold_path(); // a branch, not seven predicated instructions
    let at_least = spread(at_least & HIGH);
    Some((old & !at_least) | (new & at_least))
}

/// Marks as `stale` each cell that equals the square of its column, 255 apart.
#[inline(always)]
pub(super) fn mark(row: &mut [u8; LANES], squares: &[u8; LANES], stale: u8) {
    over(row, squares, |old, new| match zeros(old ^ new) {
        0 => None,
        equal => {
            cold_path();
            let equal = spread(equal & !zeros(!new));
            Some((old & !equal) | (every(stale) & equal))
        }
    });
}

/// Rewrites a row, given the old cells and the squares; `change` says how, if at all.
#[inline(always)]
fn over(row: &mut [u8], squares: &[u8], change: impl Fn(u32, u32) -> Option<u32>) {
    for (cells, squares) in row.as_chunks_mut().0.iter_mut().zip(squares.as_chunks().0) {
        // Most words stay as they are.
        if let Some(new) = change(u32::from_le_bytes(*cells), u32::from_le_bytes(*squares)) {
            *cells = new.to_le_bytes();
        }
    }
}

/// A bit per byte: set where `byte - from`, wrapping, is at most `span`.
#[inline(always)]
pub(super) fn within(bytes: Word, from: u8, span: u8) -> u32 {
    let (bytes, from, span) = (u32::from_le_bytes(bytes), every(from), every(span));
    gather(at_most(bytes, from, span))
}

/// The highest bit of every byte for which `byte - from`, wrapping, is at most `span`.
#[cfg(all(feature = "dsp", target_arch = "arm"))]
#[inline(always)]
fn at_most(bytes: u32, from: u32, span: u32) -> u32 {
    super::dsp::select(span, super::dsp::subtract(bytes, from), HIGH, 0)
}

/// The highest bit of every byte for which `byte - from`, wrapping, is at most `span`.
#[cfg(not(all(feature = "dsp", target_arch = "arm")))]
#[inline(always)]
fn at_most(bytes: u32, from: u32, span: u32) -> u32 {
    // Byte by byte: the highest bits apart, so that nothing borrows.
    let difference = ((bytes | HIGH) - (from & !HIGH)) ^ (!(bytes ^ from) & HIGH);
    let low = (span | HIGH) - (difference & !HIGH);
    ((span & !difference) | (!(span ^ difference) & low)) & HIGH
}

/// The highest bit of every cell, as four bits.
#[inline(always)]
fn gather(high: u32) -> u32 {
    // The product has them in its highest four bits.
    (high >> 7).wrapping_mul(0x1020_4080) >> 28
}

/// A bit per cell of up to 32: set where it equals `value`.
#[inline(always)]
pub(super) fn equal_bits(row: &[u8], value: u8) -> u32 {
    let mut bits = 0;
    let (words, rest) = row.as_chunks::<CELLS>();
    let mut lane = 0;
    for cells in words {
        let equal = zeros(u32::from_le_bytes(*cells) ^ every(value));
        if equal != 0 {
            bits |= gather(equal) << lane;
        }
        lane += CELLS as u32;
    }
    for cell in rest {
        bits |= u32::from(*cell == value) << lane;
        lane += 1;
    }
    bits
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pair_of_bytes_lowers_and_matches_as_bytes_do() {
        for old in 0..=255u8 {
            for new in 0..=255u8 {
                // Neighbours that borrow or carry the most.
                for other in [0, 127, 128, 255] {
                    let row = |a, b| core::array::from_fn(|i| if i % 2 == 0 { a } else { b });
                    let (cells, squares): ([u8; LANES], [u8; LANES]) = (row(other, old), row(255, new));
                    let mut lowered = cells;
                    lower(&mut lowered, &squares);
                    let expected = core::array::from_fn(|i| cells[i].min(squares[i]));
                    assert_eq!(lowered, expected, "{old} {new} beside {other}");
                    let mut marked = cells;
                    mark(&mut marked, &squares, 254);
                    let is_stale = |i: usize| cells[i] == squares[i] && squares[i] != 255;
                    let expected = core::array::from_fn(|i| if is_stale(i) { 254 } else { cells[i] });
                    assert_eq!(marked, expected, "{old} {new} beside {other}");
                    let bits = equal_bits(&cells[..7], new);
                    let expected = (0..7).fold(0, |b, i| b | u32::from(cells[i] == new) << i);
                    assert_eq!(bits, expected, "{old} {new} beside {other}");
                }
            }
        }
    }

    #[test]
    fn cells_of_narrow_discs_lower_and_stay_without_a_square() {
        let cells = || (0..128u8).chain([255]);
        for (old, new) in cells().flat_map(|old| (0..=NO_SQUARE).map(move |new| (old, new))) {
            for other in [0, 127, 255] {
                for beside in [0, 127, NO_SQUARE] {
                    let row = |a, b| core::array::from_fn(|i| if i % 2 == 0 { a } else { b });
                    let cells: [u8; FEW_LANES] = row(other, old);
                    let squares: [u8; FEW_LANES] = row(beside, new);
                    let mut lowered = cells;
                    lower(&mut lowered, &squares);
                    let least = |i: usize| if squares[i] == NO_SQUARE { 255 } else { squares[i] };
                    let expected = core::array::from_fn(|i| cells[i].min(least(i)));
                    assert_eq!(lowered, expected, "{old} {new} beside {other} {beside}");
                }
            }
        }
    }

    #[test]
    fn bytes_lie_within_a_wrapping_span() {
        for from in 0..=255u8 {
            for span in [0, 1, 62, 77, 127, 128, 190, 255] {
                for byte in 0..=255u8 {
                    let bytes = [byte, from, from.wrapping_add(span), byte ^ 0x80];
                    let expected = (0..4).fold(0, |bits, i| {
                        bits | u32::from(bytes[i].wrapping_sub(from) <= span) << i
                    });
                    assert_eq!(within(bytes, from, span), expected, "{bytes:?} {from} {span}");
                }
            }
        }
    }

    #[test]
    fn bits_of_rows_of_any_length() {
        let row = [254u8; 33];
        for length in 0..=32 {
            let all = if length == 32 { u32::MAX } else { (1 << length) - 1 };
            assert_eq!(equal_bits(&row[..length], 254), all);
        }
    }
}
