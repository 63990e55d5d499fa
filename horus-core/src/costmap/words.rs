//! Rows of one-byte field cells four at a time, in 32-bit words: what a core without vector
//! instructions does fastest in portable code.

use core::hint::cold_path;

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

/// Lowers each cell of both rows to `squares + across` of its column if that is less. `WIDE`
/// allows sums above 127; none exceeds 255.
#[inline(always)]
pub(super) fn lower<const WIDE: bool>(rows: [&mut [u8]; 2], squares: &[u8], across: u8) {
    over(rows, squares, across, lesser::<WIDE>);
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
        old | ((old | HIGH) - new)
    };
    if at_least & HIGH == 0 {
        return None;
    }
    cold_path(); // a branch, not seven predicated instructions
    let at_least = spread(at_least & HIGH);
    Some((old & !at_least) | (new & at_least))
}

/// Marks as `stale` each cell of both rows that equals `squares + across` of its column.
#[inline(always)]
pub(super) fn mark(rows: [&mut [u8]; 2], squares: &[u8], across: u8, stale: u8) {
    over(rows, squares, across, |old, new| match zeros(old ^ new) {
        0 => None,
        equal => {
            cold_path();
            let equal = spread(equal);
            Some((old & !equal) | (every(stale) & equal))
        }
    });
}

/// Rewrites two rows of one length, or one and an empty one, given the old cells and the sums.
/// `change` says how, if at all; it may see a cell twice.
#[inline(always)]
fn over(
    [above, below]: [&mut [u8]; 2],
    squares: &[u8],
    across: u8,
    change: impl Fn(u32, u32) -> Option<u32>,
) {
    let across = every(across);
    let sums = |squares: &Word| u32::from_le_bytes(*squares).wrapping_add(across);
    let apply = |cells: &mut Word, sums: u32| {
        // Most words stay as they are.
        if let Some(new) = change(u32::from_le_bytes(*cells), sums) {
            *cells = new.to_le_bytes();
        }
    };
    let Some(squares) = squares.get(..above.len()) else {
        return;
    };
    let (square_words, rest) = squares.as_chunks();
    if below.is_empty() {
        for (cells, squares) in above.as_chunks_mut().0.iter_mut().zip(square_words) {
            apply(cells, sums(squares));
        }
    } else {
        let words = square_words.iter().zip(above.as_chunks_mut().0);
        for ((squares, above), below) in words.zip(below.as_chunks_mut().0) {
            let sums = sums(squares);
            apply(above, sums);
            apply(below, sums);
        }
    }
    if rest.is_empty() {
        return;
    }
    match squares.last_chunk() {
        // The last word overlaps the one before.
        Some(squares) => {
            let sums = sums(squares);
            for row in [above, below] {
                if let Some(cells) = row.last_chunk_mut() {
                    apply(cells, sums);
                }
            }
        }
        None => {
            for row in [above, below] {
                for (cell, square) in row.iter_mut().zip(rest) {
                    let mut word = [*cell; CELLS];
                    apply(&mut word, sums(&[*square; CELLS]));
                    [*cell, ..] = word;
                }
            }
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
                    let cells = [other, old, other, old, other];
                    let squares = [0, new, 255, new, 0];
                    let mut lowered = cells;
                    let mut twin = lowered;
                    lower::<true>([&mut lowered, &mut twin], &squares, 0);
                    assert_eq!(lowered, twin);
                    let expected = core::array::from_fn(|i| cells[i].min(squares[i]));
                    assert_eq!(lowered, expected, "{old} {new} beside {other}");
                    if new < 128 {
                        let squares = [0, new, 127, new, 0];
                        let mut lowered = cells;
                        let mut twin = lowered;
                        lower::<false>([&mut lowered, &mut twin], &squares, 0);
                        assert_eq!(lowered, twin);
                        let expected = core::array::from_fn(|i| cells[i].min(squares[i]));
                        assert_eq!(lowered, expected, "{old} {new} beside {other}, narrow");
                    }
                    let mut marked = cells;
                    let mut twin = marked;
                    mark([&mut marked, &mut twin], &squares, 0, 254);
                    assert_eq!(marked, twin);
                    let expected =
                        core::array::from_fn(|i| if cells[i] == squares[i] { 254 } else { cells[i] });
                    assert_eq!(marked, expected, "{old} {new} beside {other}");
                    let bits = equal_bits(&cells, new);
                    let expected = (0..5).fold(0, |b, i| b | u32::from(cells[i] == new) << i);
                    assert_eq!(bits, expected, "{old} {new} beside {other}");
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
    fn rows_of_any_length_are_treated_whole() {
        for length in 0..=32 {
            let mut row = [200u8; 33];
            let squares: [u8; 33] = core::array::from_fn(|i| i as u8 * 3);
            lower::<true>([&mut row[..length], &mut []], &squares, 10);
            for (i, cell) in row.iter().enumerate() {
                let expected = if i < length {
                    (i as u8 * 3 + 10).min(200)
                } else {
                    200
                };
                assert_eq!(*cell, expected, "{i} of {length}");
            }
            mark([&mut row[..length], &mut []], &squares, 10, 254);
            assert!(row[..length].iter().all(|c| *c == 254), "{length}");
            let all = if length == 32 { u32::MAX } else { (1 << length) - 1 };
            assert_eq!(equal_bits(&row[..length], 254), all);
        }
    }
}
