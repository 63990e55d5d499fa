//! Updates, with and without a budget, and what each promises.

use horus_core::prelude::{CellRect, Error};

use super::pair::{CHECKED_CALLS, CostPair};
use super::{Budget, Width};
use crate::compare::{difference, is_within};

impl<F: Width> CostPair<'_, F> {
    /// The rectangle that one update returned.
    fn check_rect(&self, rect: Option<CellRect>, before: &[u8], kept_before: Option<&[u8]>) {
        let width = self.std.width;
        if before.is_empty() {
            return;
        }
        if self.moved {
            let whole = CellRect {
                x0: 0,
                y0: 0,
                x1: width,
                y1: self.std.height,
            };
            assert_eq!(rect, Some(whole), "after a shift");
        } else if let (Some(before), Some(after)) = (kept_before, self.core.costs()) {
            assert_eq!(rect, difference(before, after, width), "smallest rectangle");
        } else {
            let changed = difference(before, &self.read(), width);
            assert!(
                is_within(changed, rect),
                "costs changed in {changed:?}, returned {rect:?}"
            );
        }
    }

    pub(super) fn update(&mut self) {
        let (before, kept) = (self.read(), self.kept());
        let rect = self.core.update_costs();
        self.check_rect(rect, &before, kept.as_deref());
        self.moved = false;
        self.promises.updated(rect);
        self.check_exact();
    }

    /// One budgeted call; returns what is pending.
    pub(super) fn update_within(&mut self, budget: Budget, checked: bool) -> u32 {
        let budget = budget.visits(self.core.min_budget());
        let before = checked.then(|| (self.read(), self.kept()));
        let update = self
            .core
            .update_costs_within(budget)
            .expect("the budget is legal");
        if let Some((before, kept)) = before {
            self.check_rect(update.changed, &before, kept.as_deref());
        }
        self.moved = false;
        self.promises.updated(update.changed);
        let left = self.core.calls_left();
        assert_eq!(
            update.pending == 0,
            left == 0,
            "pending {}, calls left {left}",
            update.pending
        );
        if update.pending == 0 {
            self.check_exact();
        } else if checked {
            self.check_pending();
        }
        update.pending
    }

    /// Once the additions are in, no known cell is cheaper than its final cost.
    fn check_pending(&mut self) {
        let params = self.params.1;
        let is_source = |v: i8| v >= params.lethal_threshold || v < 0 && params.unknown_inflates;
        let data = &self.std.data;
        let least = self.core.min_budget();
        if !self.promises.additions_are_in(|i| is_source(data[i]), least) {
            return;
        }
        let (expected, read) = (self.expected(), self.read());
        for (i, value) in self.std.data.iter().enumerate() {
            let (gx, gy) = (i as u32 % self.std.width, i as u32 / self.std.width);
            assert!(
                *value < 0 || read[i] >= expected[i],
                "pending: known cell ({gx}, {gy}) costs {}, finally {}",
                read[i],
                expected[i]
            );
        }
    }

    pub(super) fn too_little(&mut self, part: u16) {
        let least = self.core.min_budget();
        let given = u32::from(part) % least;
        let (read, kept, left) = (self.read(), self.kept(), self.core.calls_left());
        let refused = self.core.update_costs_within(given);
        assert_eq!(refused, Err(Error::BudgetTooSmall { min: least, given }));
        assert!(
            read == self.read() && kept == self.kept() && left == self.core.calls_left(),
            "a refused update does nothing"
        );
    }

    pub(super) fn drain(&mut self, budget: Budget) {
        let promised = self.core.calls_left();
        let mut calls = 0;
        while self.core.calls_left() > 0 {
            self.update_within(budget, calls < CHECKED_CALLS);
            calls += 1;
            assert!(
                calls <= promised,
                "{calls} calls made, {promised} were promised to do"
            );
        }
        if calls == 0 {
            self.check_exact();
        }
    }
}
