//! The passes of an update: sources that appeared, strips along the edges, sources that vanished,
//! kept cost bytes. Each returns false if the budget ended first, and goes on from there later.

use super::CellValue;
use super::budget::Budget;
use super::changes::{Changes, Next};
use super::edges::Side;
use super::field::FieldCell;
use super::kernel::stamp::Stamp;
use super::layer::{Layer, Parts};
use super::repair::Scope;
use super::stale::Stale;
use super::steps::BLOCK;
use super::work::Work;
use crate::geometry::{Bounds, CellRect};

impl<F: FieldCell> Layer<'_, F> {
    /// Applies the sources that appeared.
    pub(super) fn insert<V: CellValue>(
        &mut self,
        values: &[V],
        budget: &mut Budget,
        work: &mut Work,
        changed: &mut Bounds,
    ) -> bool {
        let steps = self.steps();
        let kept = self.costs.is_some();
        let mut cursor = self.cursors.insert;
        let finished = loop {
            let w = match next_word(&self.changes, &mut cursor, steps.word, budget) {
                Ok(w) => w,
                Err(finished) => break finished,
            };
            let (x0, gy) = self.changes.cell(w);
            let mut bits = self.changes.word(w);
            let mut settled = 0;
            let mut out_of_budget = false;
            while bits != 0 {
                let bit = bits & bits.wrapping_neg();
                bits ^= bit;
                let gx = x0 + bit.trailing_zeros();
                let Some((is, was)) = self.source_change(values, w, bit, gx, gy) else {
                    continue;
                };
                if is && !was {
                    if !budget.take(steps.insert) {
                        out_of_budget = true;
                        break;
                    }
                    if let Some(word) = self.sources.get_mut(w) {
                        *word |= bit;
                    }
                    if !work.is_flooded() {
                        self.stamp(gx, gy, values, changed);
                    }
                    work.add(Work::INSERT);
                }
                if is || !was {
                    settled |= bit; // only a removal waits
                    if !kept {
                        changed.add(gx, gy);
                    }
                }
            }
            if !kept {
                self.changes.unmark(w, settled);
            }
            if out_of_budget {
                break false;
            }
            cursor = w + 1;
        };
        self.cursors.insert = cursor;
        finished
    }

    /// Whether a changed cell is a source now, and whether the field reflects it as one.
    #[inline]
    fn source_change<V: CellValue>(
        &self,
        values: &[V],
        w: usize,
        bit: u32,
        gx: u32,
        gy: u32,
    ) -> Option<(bool, bool)> {
        let value = values.get(gy as usize * self.width as usize + gx as usize)?;
        let was = self.sources.get(w)? & bit != 0;
        Some((self.tables.is_source(value.byte()), was))
    }

    /// Lowers the field around a new source.
    fn stamp<V: CellValue>(&mut self, gx: u32, gy: u32, values: &[V], changed: &mut Bounds) {
        let size = (self.width, self.height);
        let (Parts { field, .. }, mut refresh) = self.refresh(values, changed);
        let (disc, rows) = (refresh.tables.disc, &refresh.tables.rows);
        let rect = Stamp::Lower.disc(field, size, disc, rows, (gx, gy));
        refresh.rect(field, rect);
    }

    /// Recomputes the strips that window shifts left along the edges.
    pub(super) fn repair_edges<V: CellValue>(
        &mut self,
        values: &[V],
        budget: &mut Budget,
        changed: &mut Bounds,
    ) -> bool {
        if self.edges.is_empty() {
            return true;
        }
        let block = self.steps().block;
        let mut first = 0;
        for side in Side::ALL {
            let Some(strip) = self.strip(side) else {
                continue;
            };
            let scope = Scope::Edge(side, self.edges.edge(side));
            let row_blocks = strip.height().div_ceil(BLOCK).max(1);
            let end = first + row_blocks * strip.width().div_ceil(BLOCK);
            while self.edges.done < end {
                let at = self.edges.done - first;
                let (column, row) = (at / row_blocks, at % row_blocks);
                if !budget.take(block) {
                    return false;
                }
                // Without a budget a column of blocks is one piece of work.
                let rows = if budget.is_limited() { 1 } else { row_blocks - row };
                let rect = CellRect {
                    x0: strip.x0 + column * BLOCK,
                    y0: strip.y0 + row * BLOCK,
                    x1: strip.x1.min(strip.x0 + (column + 1) * BLOCK),
                    y1: strip.y1.min(strip.y0 + (row + rows) * BLOCK),
                };
                self.repair(rect, scope, values, changed);
                self.edges.done += rows;
            }
            first = end;
        }
        self.edges.clear();
        true
    }

    /// The cells of the strip along one edge.
    fn strip(&self, side: Side) -> Option<CellRect> {
        let (w, h) = (self.width, self.height);
        let edge = self.edges.edge(side);
        if edge.width == 0 {
            return None;
        }
        let whole = CellRect {
            x0: 0,
            y0: 0,
            x1: w,
            y1: h,
        };
        Some(match side {
            Side::Left => CellRect {
                x1: edge.width.min(w),
                ..whole
            },
            Side::Right => CellRect {
                x0: w.saturating_sub(edge.width),
                ..whole
            },
            Side::Bottom => CellRect {
                y1: edge.width.min(h),
                ..whole
            },
            Side::Top => CellRect {
                y0: h.saturating_sub(edge.width),
                ..whole
            },
        })
    }

    /// Blocks of edge strips that wait.
    pub(super) fn blocks_left(&self) -> u32 {
        let blocks = |side| {
            self.strip(side)
                .map_or(0, |s| s.height().div_ceil(BLOCK) * s.width().div_ceil(BLOCK))
        };
        let all: u32 = Side::ALL.into_iter().map(blocks).sum();
        all.saturating_sub(self.edges.done)
    }

    /// Applies the sources that vanished: marks the cells whose nearest source they may have been,
    /// then recomputes those. With a budget, one source after another.
    pub(super) fn remove<V: CellValue>(
        &mut self,
        values: &[V],
        budget: &mut Budget,
        work: &mut Work,
        changed: &mut Bounds,
    ) -> bool {
        let steps = self.steps();
        let kept = self.costs.is_some();
        let mut stale = Stale::default();
        let mut cursor = self.cursors.remove;
        let finished = loop {
            let w = match next_word(&self.changes, &mut cursor, steps.word, budget) {
                Ok(w) => w,
                Err(finished) => break finished,
            };
            let (x0, gy) = self.changes.cell(w);
            let mut bits = self.changes.word(w) & self.sources.get(w).copied().unwrap_or(0);
            let mut out_of_budget = false;
            while bits != 0 {
                let bit = bits & bits.wrapping_neg();
                bits ^= bit;
                let gx = x0 + bit.trailing_zeros();
                let Some((false, true)) = self.source_change(values, w, bit, gx, gy) else {
                    continue;
                };
                if !budget.take(steps.remove) {
                    out_of_budget = true;
                    break;
                }
                if let Some(word) = self.sources.get_mut(w) {
                    *word &= !bit;
                }
                if !work.is_flooded() {
                    self.mark_stale(gx, gy, &mut stale);
                }
                work.add(Work::REMOVE);
                if !kept {
                    self.changes.unmark(w, bit);
                    changed.add(gx, gy);
                }
                if budget.is_limited() {
                    self.repair_stale(&mut stale, values, changed);
                }
            }
            if out_of_budget {
                break false;
            }
            cursor = w + 1;
        };
        if work.is_flooded() {
            self.repair_all(values, changed);
        } else {
            self.repair_stale(&mut stale, values, changed);
        }
        self.cursors.remove = cursor;
        finished
    }

    /// Writes the kept costs of the cells whose values changed.
    pub(super) fn write_costs<V: CellValue>(
        &mut self,
        values: &[V],
        budget: &mut Budget,
        changed: &mut Bounds,
    ) -> bool {
        let steps = self.steps();
        let Some(costs) = self.costs.as_deref_mut() else {
            return true;
        };
        let mut cursor = self.cursors.costs;
        let finished = loop {
            let w = match next_word(&self.changes, &mut cursor, steps.costs, budget) {
                Ok(w) => w,
                Err(finished) => break finished,
            };
            let (x0, gy) = self.changes.cell(w);
            let mut bits = self.changes.word(w);
            self.changes.unmark(w, bits);
            while bits != 0 {
                let gx = x0 + bits.trailing_zeros();
                bits &= bits - 1;
                let i = gy as usize * self.width as usize + gx as usize;
                if let Some(cost) = costs.get_mut(i)
                    && let Some(value) = values.get(i)
                    && let Some(field) = self.field.get(i)
                    && self.tables.refresh(cost, *value, *field)
                {
                    changed.add(gx, gy);
                }
            }
            cursor = w + 1;
        };
        self.cursors.costs = cursor;
        finished
    }
}

/// The next word of changes at or after the cursor, paid for with `visits`; an error ends the
/// pass and tells whether it is finished.
fn next_word(
    changes: &Changes<'_>,
    cursor: &mut usize,
    visits: u32,
    budget: &mut Budget,
) -> Result<usize, bool> {
    match changes.next_from(cursor, || budget.take(1)) {
        Next::Word(w) if budget.take(visits) => Ok(w),
        Next::Word(_) | Next::OutOfBudget => Err(false),
        Next::End => Err(true),
    }
}
