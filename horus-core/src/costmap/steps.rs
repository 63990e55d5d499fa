//! The steps an update is made of, and what each may visit at most.

use super::kernel::Disc;

/// Rows and columns of one block of an edge strip.
pub(crate) const BLOCK: u32 = 32;

/// Upper bounds, in cell visits, of the steps of an update: a visit is one field or cost byte
/// read or written, or one bitmap word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Steps {
    /// Looking at one word of changes.
    pub word: u32,
    /// A source appears.
    pub insert: u32,
    /// A source vanishes.
    pub remove: u32,
    /// One block of an edge strip.
    pub block: u32,
    /// Writing the kept costs of one word of changes.
    pub costs: u32,
}

impl Steps {
    pub(crate) fn new(disc: Disc) -> Self {
        let side = disc.side();
        let cells = side * side;
        // Bringing the kept cost of a cell up to date: its change word, cost read and written.
        let refresh = 3;
        // Source words for `rows` rows of one strip of 32 columns.
        let words = |rows: u32| (rows + 2 * disc.radius) * (4 + 2 * disc.radius.div_ceil(32));
        let strips = if side <= 32 { 1 } else { side / 32 + 2 };
        Self {
            word: 2,
            insert: 2 + cells * (2 + refresh),
            remove: 2 + 2 * cells + strips * (32 * side + words(side)) + cells * (1 + refresh),
            block: BLOCK * BLOCK * (2 + refresh) + words(BLOCK),
            costs: 2 + 32 * refresh,
        }
    }

    /// The largest step, S(R); one more visit finds the word it works on.
    pub(crate) fn largest(&self) -> u32 {
        1 + self.word + self.insert.max(self.remove).max(self.block).max(self.costs)
    }
}
