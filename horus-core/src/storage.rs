//! Caller-provided storage: bitmaps over grids, and moving a window's contents in place.

use core::hint::black_box;

/// Words of one bitmap row: rows start on a word, bits past the width stay zero.
pub(crate) const fn words_per_row(width: u32) -> usize {
    (width as usize).div_ceil(32)
}

/// `u32` words that one bit per cell of a `width` x `height` grid takes; rows start on a word.
///
/// ```
/// assert_eq!(horus_core::storage::bitmap_words(200, 200), 7 * 200);
/// ```
pub const fn bitmap_words(width: u32, height: u32) -> usize {
    words_per_row(width) * height as usize
}

/// Moves a window over row-major cells: cell (gx, gy) takes what was at (gx + dx, gy + dy);
/// cells that come into view are set to `fill`.
///
/// Complexity: one read and one write per cell; a zero shift returns at once.
pub(crate) fn shift_cells<T: Copy>(cells: &mut [T], width: u32, height: u32, shift: [i32; 2], fill: T) {
    shift_in_place(cells, (width, height), shift, black_box(&fill));
}

// A value behind a reference that the compiler knows nothing about: so the functions for `i8` and
// for `u8` are the same, and the flash holds one.
#[inline(never)]
fn shift_in_place<T: Copy>(cells: &mut [T], (width, height): (u32, u32), [dx, dy]: [i32; 2], fill: &T) {
    let (w, h) = (width as usize, height as usize);
    if (dx == 0 && dy == 0) || w == 0 {
        return;
    }
    let (ax, ay) = (dx.unsigned_abs() as usize, dy.unsigned_abs() as usize);
    if ax >= w || ay >= h {
        fill_with(cells, fill);
        return;
    }
    // One move of the whole block: the cells that wrap around a row end are filled below.
    let delta = dy as isize * w as isize + dx as isize;
    let distance = delta.unsigned_abs();
    if distance >= cells.len() {
        fill_with(cells, fill);
        return;
    }
    move_by(cells, delta);
    let new_rows = if dy > 0 { h - ay..h } else { 0..ay };
    if let Some(rows) = cells.get_mut(new_rows.start * w..new_rows.end * w) {
        fill_with(rows, fill);
    }
    let new_columns = if dx > 0 { w - ax..w } else { 0..ax };
    if ax > 0 {
        for row in cells.chunks_exact_mut(w) {
            if let Some(columns) = row.get_mut(new_columns.clone()) {
                fill_with(columns, fill);
            }
        }
    }
}

/// Sets all cells: a loop over four at a time, shorter and on short rows faster than `memset`,
/// which the standard library's `fill` calls.
#[inline]
pub(crate) fn fill<T: Copy>(cells: &mut [T], value: T) {
    fill_with(cells, black_box(&value));
}

#[inline(never)]
fn fill_with<T: Copy>(cells: &mut [T], value: &T) {
    let value = *value;
    if size_of::<T>() > 2 {
        cells.fill(value); // no bytes: a loop
        return;
    }
    // What the compiler cannot see through it does not recognise as a `memset` either.
    let four = black_box([value; 4]);
    let (fours, rest) = cells.as_chunks_mut();
    fours.iter_mut().for_each(|to| *to = four);
    match rest {
        [a] => *a = value,
        [a, b] => [*a, *b] = [value; 2],
        [a, b, c] => [*a, *b, *c] = [value; 3],
        _ => {}
    }
}

/// Copies `2 * N` elements within a slice: all are read before one is written. Two arrays of eight
/// bytes are moved in registers, unaligned, where a longer one would be a call of `memmove`.
#[inline(always)]
fn copy_block<T: Copy, const N: usize>(cells: &mut [T], from: usize, to: usize) -> Option<()> {
    let (near, far) = cells.get(from..from + 2 * N)?.split_first_chunk::<N>()?;
    let (near, far) = (*near, *far.first_chunk::<N>()?);
    let (to_near, to_far) = cells.get_mut(to..to + 2 * N)?.split_first_chunk_mut::<N>()?;
    *to_near = near;
    *to_far.first_chunk_mut::<N>()? = far;
    Some(())
}

/// `cells[i] = cells[i + delta]` where both are there.
fn move_by<T: Copy>(cells: &mut [T], delta: isize) {
    let distance = delta.unsigned_abs();
    match (size_of::<T>(), delta > 0) {
        (1, true) => move_down::<T, 8>(cells, distance),
        (1, false) => move_up::<T, 8>(cells, distance),
        (2, true) => move_down::<T, 4>(cells, distance),
        (2, false) => move_up::<T, 4>(cells, distance),
        (_, true) => move_down::<T, 2>(cells, distance),
        (_, false) => move_up::<T, 2>(cells, distance),
    }
}

/// `cells[i] = cells[i + distance]`, ascending.
fn move_down<T: Copy, const N: usize>(cells: &mut [T], distance: usize) {
    let moved = cells.len().saturating_sub(distance);
    let mut at = 0;
    while at + 2 * N <= moved && copy_block::<T, N>(cells, at + distance, at).is_some() {
        at += 2 * N;
    }
    while at < moved {
        if let Some(&value) = cells.get(at + distance)
            && let Some(to) = cells.get_mut(at)
        {
            *to = value;
        }
        at += 1;
    }
}

/// `cells[i] = cells[i - distance]`, descending.
fn move_up<T: Copy, const N: usize>(cells: &mut [T], distance: usize) {
    let mut at = cells.len();
    while let Some(to) = at.checked_sub(2 * N)
        && let Some(from) = to.checked_sub(distance)
        && copy_block::<T, N>(cells, from, to).is_some()
    {
        at = to;
    }
    while at > distance {
        at -= 1;
        if let Some(&value) = cells.get(at - distance)
            && let Some(to) = cells.get_mut(at)
        {
            *to = value;
        }
    }
}

/// A bitmap whose rows start on a word, borrowed for reading.
#[derive(Clone, Copy)]
pub(crate) struct Bitmap<'a> {
    words: &'a [u32],
    width: u32,
    height: u32,
}

impl<'a> Bitmap<'a> {
    pub(crate) fn new(words: &'a [u32], width: u32, height: u32) -> Self {
        Self { words, width, height }
    }

    pub(crate) fn width(&self) -> u32 {
        self.width
    }

    pub(crate) fn height(&self) -> u32 {
        self.height
    }

    /// The words of a row; empty outside the grid.
    #[inline]
    pub(crate) fn row(&self, gy: i32) -> &'a [u32] {
        let per_row = words_per_row(self.width);
        if gy < 0 || gy as u32 >= self.height {
            return &[];
        }
        self.words
            .get(gy as usize * per_row..(gy as usize + 1) * per_row)
            .unwrap_or(&[])
    }
}

/// The 32 bits of a bitmap row that start at column `x`, which may lie outside: zeros there.
#[inline]
pub(crate) fn bits_at(row: &[u32], x: i32) -> u32 {
    let word = |i: i32| row.get(i as usize).copied().unwrap_or(0); // a negative index is too large
    let (i, shift) = (x >> 5, x & 31);
    if shift == 0 {
        word(i)
    } else {
        word(i) >> shift | word(i + 1) << (32 - shift)
    }
}

/// Moves a bitmap's window as [`shift_cells`] does; bits that come into view are zero.
///
/// Complexity: two words read and one written per word.
pub(crate) fn shift_bits(words: &mut [u32], width: u32, height: u32, shift: [i32; 2]) {
    let [dx, dy] = shift;
    let per_row = words_per_row(width);
    let last_bits = if width.is_multiple_of(32) {
        u32::MAX
    } else {
        (1 << (width % 32)) - 1
    };
    let whole = (i64::from(dx).abs() >= i64::from(width)) || (i64::from(dy).abs() >= i64::from(height));
    if whole {
        words.fill(0);
        return;
    }
    if dx == 0 {
        let new = dy.unsigned_abs() as usize * per_row;
        let kept = words.len().saturating_sub(new);
        move_by(words, dy as isize * per_row as isize);
        let new = if dy > 0 { kept..words.len() } else { 0..new };
        words.get_mut(new).unwrap_or_default().fill(0);
        return;
    }
    let move_row = |words: &mut [u32], gy: i32| {
        let source = gy + dy;
        let to = gy as usize * per_row;
        if source < 0 || source as u32 >= height {
            if let Some(row) = words.get_mut(to..to + per_row) {
                row.fill(0);
            }
            return;
        }
        let from = source as usize * per_row;
        let mut move_word = |i: usize| {
            let bits = words
                .get(from..from + per_row)
                .map_or(0, |row| bits_at(row, 32 * i as i32 + dx));
            let mask = if i + 1 == per_row { last_bits } else { u32::MAX };
            if let Some(word) = words.get_mut(to + i) {
                *word = bits & mask;
            }
        };
        for i in 0..per_row {
            move_word(if dx > 0 { i } else { per_row - 1 - i });
        }
    };
    // A word must be read before it is overwritten.
    for gy in 0..height as i32 {
        move_row(words, if dy >= 0 { gy } else { height as i32 - 1 - gy });
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use std::vec::Vec;

    #[test]
    fn shifts_equal_a_cell_by_cell_copy() {
        for (w, h) in [(1u32, 1u32), (3, 2), (1, 9), (9, 1), (33, 4), (64, 3), (40, 5)] {
            let old: Vec<u8> = (0..w * h).map(|i| (i * 37 % 251) as u8).collect();
            for dx in -(w as i32) - 1..=w as i32 + 1 {
                for dy in -(h as i32) - 1..=h as i32 + 1 {
                    let at = |gx: u32, gy: u32| {
                        let (x, y) = (gx as i32 + dx, gy as i32 + dy);
                        let inside = x >= 0 && y >= 0 && (x as u32) < w && (y as u32) < h;
                        inside.then(|| old[(y as u32 * w + x as u32) as usize])
                    };
                    let mut cells = old.clone();
                    shift_cells(&mut cells, w, h, [dx, dy], 255);
                    let mut bits = std::vec![0u32; bitmap_words(w, h)];
                    for (i, v) in old.iter().enumerate() {
                        let (gx, gy) = (i as u32 % w, i as u32 / w);
                        if v % 3 == 0 {
                            bits[gy as usize * words_per_row(w) + gx as usize / 32] |= 1 << (gx % 32);
                        }
                    }
                    shift_bits(&mut bits, w, h, [dx, dy]);
                    let bitmap = Bitmap::new(&bits, w, h);
                    for gy in 0..h {
                        for gx in 0..w {
                            let expected = at(gx, gy);
                            assert_eq!(cells[(gy * w + gx) as usize], expected.unwrap_or(255));
                            let bit = bits_at(bitmap.row(gy as i32), gx as i32) & 1 == 1;
                            assert_eq!(bit, expected.is_some_and(|v| v % 3 == 0), "{w}x{h} {dx},{dy}");
                        }
                        let past = bits_at(bitmap.row(gy as i32), w as i32);
                        assert_eq!(past, 0, "bits past the width stay zero");
                    }
                }
            }
        }
    }
}
