use crate::storage::{shift_bits, words_per_row};

/// The cells that changed since their costs were last brought up to date: one bit per cell, and
/// one summary bit per word of those, so that finding them costs little on a quiet map.
#[derive(Debug)]
pub(crate) struct Changes<'a> {
    words: &'a mut [u32],
    summary: &'a mut [u32],
    width: u32,
    height: u32,
    /// Set bits in `words`.
    count: u32,
}

/// The next word that has changes.
pub(crate) enum Next {
    Word(usize),
    End,
    /// The budget ended first; the cursor has moved on.
    OutOfBudget,
}

impl<'a> Changes<'a> {
    pub(crate) fn new(words: &'a mut [u32], summary: &'a mut [u32], width: u32, height: u32) -> Self {
        let mut changes = Self {
            words,
            summary,
            width,
            height,
            count: 0,
        };
        changes.clear();
        changes
    }

    pub(crate) fn clear(&mut self) {
        self.words.fill(0);
        self.summary.fill(0);
        self.count = 0;
    }

    pub(crate) fn count(&self) -> u32 {
        self.count
    }

    /// Marks a cell inside the grid; returns its word.
    #[inline]
    pub(crate) fn mark(&mut self, gx: u32, gy: u32) -> usize {
        let w = gy as usize * words_per_row(self.width) + gx as usize / 32;
        if let Some(word) = self.words.get_mut(w)
            && let Some(summary) = self.summary.get_mut(w / 32)
        {
            let bit = 1 << (gx % 32);
            self.count += u32::from(*word & bit == 0);
            *word |= bit;
            *summary |= 1 << (w % 32);
        }
        w
    }

    #[inline]
    pub(crate) fn word(&self, w: usize) -> u32 {
        self.words.get(w).copied().unwrap_or(0)
    }

    /// The words of a row inside the grid.
    pub(crate) fn row(&self, gy: u32) -> &[u32] {
        let per_row = words_per_row(self.width);
        let start = gy as usize * per_row;
        self.words.get(start..start + per_row).unwrap_or_default()
    }

    /// Forgets the `bits` of a word.
    pub(crate) fn unmark(&mut self, w: usize, bits: u32) {
        if let Some(word) = self.words.get_mut(w) {
            self.count -= (*word & bits).count_ones();
            *word &= !bits;
            if *word == 0
                && let Some(summary) = self.summary.get_mut(w / 32)
            {
                *summary &= !(1 << (w % 32));
            }
        }
    }

    /// Column and row of a word's first bit.
    pub(crate) fn cell(&self, w: usize) -> (u32, u32) {
        let per_row = words_per_row(self.width).max(1) as u32;
        let w = w as u32;
        (w % per_row * 32, w / per_row)
    }

    /// The first word at or after `cursor` that has changes; `visit` is asked before every
    /// summary word is read and ends the search by returning false.
    pub(crate) fn next_from(&self, cursor: &mut usize, mut visit: impl FnMut() -> bool) -> Next {
        if self.count == 0 {
            return Next::End;
        }
        while let Some(&summary) = self.summary.get(*cursor / 32) {
            if !visit() {
                return Next::OutOfBudget;
            }
            let rest = summary >> (*cursor % 32);
            if rest != 0 {
                *cursor += rest.trailing_zeros() as usize;
                return Next::Word(*cursor);
            }
            *cursor = (*cursor / 32 + 1) * 32;
        }
        Next::End
    }

    /// Moves the window: marks move with their cells, those that leave are forgotten.
    pub(crate) fn shift(&mut self, shift: [i32; 2]) {
        if self.count == 0 {
            return;
        }
        shift_bits(self.words, self.width, self.height, shift);
        self.count = 0;
        self.summary.fill(0);
        for (words, summary) in self.words.chunks(32).zip(self.summary.iter_mut()) {
            for (i, word) in words.iter().enumerate() {
                self.count += word.count_ones();
                *summary |= u32::from(*word != 0) << i;
            }
        }
    }
}
