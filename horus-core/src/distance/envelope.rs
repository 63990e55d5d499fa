//! One row: every column whose nearest obstacle lies `g` rows away raises the parabola
//! `(x - column)^2 + g^2`; the row's distances are the lowest of them.

/// A column that is nearest to some cells of a row: scratch memory of a distance map, 12 bytes.
#[derive(Clone, Copy, Debug)]
pub struct EnvelopeVertex {
    column: u32,
    /// `column^2 + g^2`: what two parabolas have in common cancels out, so these alone tell where they cross.
    height: u32,
    /// First cell of the row that it is nearest to.
    start: u32,
}

impl EnvelopeVertex {
    /// All bits zero; the contents do not matter.
    pub const EMPTY: Self = Self {
        column: 0,
        height: 0,
        start: 0,
    };
}

/// The start of a parabola that does not exist.
const NONE: u32 = u32::MAX;

/// The lower envelope of a row, read from right to left.
pub(super) struct Envelope<'a> {
    /// What the cells farther to the left are nearest to, from left to right.
    vertices: &'a [EnvelopeVertex],
    /// The parabola that cells are taken from now: its column, the square of its `g`, and where it starts.
    column: u32,
    bottom: u32,
    start: u32,
}

impl<'a> Envelope<'a> {
    /// The envelope of a row, `distance` being that of a column to its obstacle; columns whose obstacle is farther than
    /// `reach` raise no parabola. It lies in the first part of `vertices`.
    ///
    /// Rows and `reach` are at most [`MAX_SIDE`](super::MAX_SIDE): sums of two squares fit 31 bits.
    // A frame of its own: within its caller half of what the loop works with lies on the stack.
    #[inline(never)]
    pub(super) fn build<D: Copy>(
        vertices: &'a mut [EnvelopeVertex],
        row: &[D],
        distance: impl Fn(D) -> u32,
        reach: u32,
    ) -> Self {
        let width = row.len() as u32;
        let mut used = 0_usize;
        let mut last = EnvelopeVertex::EMPTY;
        for (column, cell) in (0_u32..).zip(row) {
            let distance = distance(*cell);
            if distance > reach {
                continue;
            }
            let height = column * column + distance * distance;
            let mut start = 0;
            while used > 0 {
                let higher = height as i32 - last.height as i32;
                let apart = 2 * (column - last.column);
                if higher >= (apart * last.start) as i32 {
                    // Columns ascend, so they are apart.
                    start = (higher as u32)
                        .checked_div(apart)
                        .map_or(0, |crossing| crossing + 1);
                    break;
                }
                // They cross before the last one's start: it is hidden altogether.
                used -= 1;
                if let Some(before) = used.checked_sub(1).and_then(|i| vertices.get(i)) {
                    last = *before;
                }
            }
            if start < width
                && let Some(slot) = vertices.get_mut(used)
            {
                last = EnvelopeVertex {
                    column,
                    height,
                    start,
                };
                *slot = last;
                used += 1;
            }
        }
        let mut envelope = Self {
            vertices: vertices.get(..used).unwrap_or_default(),
            column: 0,
            bottom: 0,
            start: NONE,
        };
        envelope.step();
        envelope
    }

    /// True if no column has an obstacle within reach.
    pub(super) fn is_empty(&self) -> bool {
        self.start == NONE
    }

    /// Goes on to a cell, any number of cells to the left.
    #[inline(always)]
    pub(super) fn go_to(&mut self, x: u32) {
        while x < self.start && self.step() {}
    }

    /// The squared distance of the cell gone to, or of the one to the left of the one asked for before; of an envelope
    /// that is not empty.
    #[inline(always)]
    pub(super) fn squared(&mut self, x: u32) -> u32 {
        // Starts are strictly ascending: there is one vertex to go on to at most.
        if x < self.start {
            self.step();
        }
        let dx = x.wrapping_sub(self.column);
        dx.wrapping_mul(dx) + self.bottom // the square of a negative number, too
    }

    /// Goes on to the parabola to the left; `false` if there is none.
    #[inline(always)]
    fn step(&mut self) -> bool {
        let Some((vertex, before)) = self.vertices.split_last() else {
            return false;
        };
        self.vertices = before;
        self.column = vertex.column;
        self.bottom = vertex.height - vertex.column * vertex.column;
        self.start = vertex.start;
        true
    }
}
