use super::budget::Budget;
use super::kernel::PREFER_LANES;

/// What an update without a budget has spent on single sources, so that it can tell when
/// recomputing everything is cheaper. The switch cannot change a result.
#[derive(Debug)]
pub(super) struct Work {
    spent: u32,
    full: u32,
    per_source: u32,
}

impl Work {
    /// A full recompute costs about as much as this many field writes per cell: measured, with
    /// either kernel.
    const FULL_WRITES_PER_CELL: u32 = if PREFER_LANES { 6 } else { 14 };
    /// A source that appears writes its disc once; one that vanishes costs this many times that.
    pub(super) const INSERT: u32 = 1;
    pub(super) const REMOVE: u32 = if PREFER_LANES { 4 } else { 2 };

    pub(super) fn new(cells: usize, disc_cells: u32, budget: &Budget) -> Self {
        let full = if budget.is_limited() {
            u32::MAX
        } else {
            (cells as u32).saturating_mul(Self::FULL_WRITES_PER_CELL)
        };
        Self {
            spent: 0,
            full,
            per_source: disc_cells,
        }
    }

    pub(super) fn add(&mut self, weight: u32) {
        self.spent = self.spent.saturating_add(self.per_source.saturating_mul(weight));
    }

    /// From now on only the source bits follow; everything is recomputed at the end.
    pub(super) fn is_flooded(&self) -> bool {
        self.spent >= self.full
    }
}
