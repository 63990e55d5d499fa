//! One row on 64-bit cores: 64 cells at a time look further and further to the left and right, in lanes that the
//! compiler vectorises, until none can find anything nearer. That pays while everything lies near.
//!
//! A distance changes by at most one cell from row to row, so the row before tells that no cell has to look farther
//! than [`LOOK`]; otherwise the row is left to the envelope, and the time stays linear.

/// Cells in a block.
pub(super) const BLOCK: usize = 64;
/// How far a block looks to either side.
pub(super) const LOOK: usize = 48;
/// The height of a column without an obstacle: more than any distance that is looked for, and still a sum that fits.
const FAR: i16 = i16::MAX - (LOOK * LOOK) as i16;
/// The root of what is below `FAR`.
const NEAR: u32 = 173;

/// A block of cells and what lies around it: squared distances of columns to their obstacles.
pub(super) struct Lanes {
    heights: [i16; LOOK + BLOCK + LOOK],
    /// Obstacles farther away do not matter.
    near: u32,
}

impl Lanes {
    /// The columns around `start`, so that the first [`slide`](Self::slide) reaches the block that starts there.
    /// `reach` is as for an envelope, `distance` that of a column to its obstacle.
    pub(super) fn before<D: Copy>(row: &[D], start: usize, reach: u32, distance: impl Fn(D) -> u32) -> Self {
        let mut lanes = Self {
            heights: [FAR; LOOK + BLOCK + LOOK],
            near: reach.min(NEAR),
        };
        let (first, missing) = (start.saturating_sub(LOOK), LOOK.saturating_sub(start));
        let end = row.len().min(start + LOOK);
        lanes.put(BLOCK + missing, row.get(first..end).unwrap_or_default(), distance);
        lanes
    }

    /// Goes on to the next block; `ahead` are the cells from `LOOK` after its first one on.
    #[inline(always)]
    pub(super) fn slide<D: Copy>(&mut self, ahead: &[D], distance: impl Fn(D) -> u32) {
        self.heights.copy_within(BLOCK.., 0);
        let (_, new) = self.heights.split_at_mut(2 * LOOK);
        new.fill(FAR);
        self.put(2 * LOOK, ahead, distance);
    }

    #[inline(always)]
    fn put<D: Copy>(&mut self, slot: usize, cells: &[D], distance: impl Fn(D) -> u32) {
        let near = self.near;
        for (slot, cell) in self.heights.iter_mut().skip(slot).zip(cells) {
            let distance = distance(*cell);
            let height = distance.min(near) as i16;
            *slot = if distance > near { FAR } else { height * height };
        }
    }

    /// The squared distances of the block's cells; the first `used` of them count.
    #[inline(always)]
    pub(super) fn squared(&self, used: usize) -> [i16; BLOCK] {
        let mut squared = [FAR; BLOCK];
        let (_, middle) = self.heights.split_at(LOOK);
        squared
            .iter_mut()
            .zip(middle)
            .for_each(|(s, height)| *s = *height);
        for k in 1..=LOOK {
            let (left, right) = (
                self.heights.split_at(LOOK - k).1,
                self.heights.split_at(LOOK + k).1,
            );
            for ((s, l), r) in squared.iter_mut().zip(left).zip(right) {
                *s = (*s).min((*l).min(*r) + (k * k) as i16);
            }
            if k % 4 == 0 {
                let counted = squared.get(..used).unwrap_or_default();
                let farthest = counted.iter().fold(0, |farthest, s| farthest.max(*s));
                // Whatever has not been looked at is at least as far as this.
                if usize::from(farthest.unsigned_abs()) <= (k + 1) * (k + 1) {
                    break;
                }
            }
        }
        squared
    }
}
