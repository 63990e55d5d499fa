//! How the scripted drives are streamed as frames.

use horus_core::costmap::FieldCell;
use horus_core::frames::{StreamOptions, StreamTick};
use horus_core::prelude::*;

use crate::drive::{Scenario, Tick};

/// All maps of a scenario: whole every tenth tick, checked every fourth.
pub fn options(scenario: &Scenario) -> StreamOptions<'static> {
    StreamOptions {
        model: scenario.model,
        key_every: 10,
        checksum_every: 4,
        ..StreamOptions::default()
    }
}

/// A tick of a drive as a tick of a stream.
///
/// The rectangle of an update may hold cells that were written back to their old value, and the
/// kernels differ in these. Here the bytes must be the same on every machine, so the costs that may
/// have changed are told from the scan's changes, which every machine finds alike.
pub fn tick<'a, F: FieldCell>(map: &CostMap<'_, F>, tick: &Tick<'a>) -> StreamTick<'a> {
    let reach = map.effective_radius();
    let around = |rect: CellRect| CellRect {
        x0: rect.x0.saturating_sub(reach),
        y0: rect.y0.saturating_sub(reach),
        x1: rect.x1 + reach,
        y1: rect.y1 + reach,
    };
    let whole = CellRect {
        x0: 0,
        y0: 0,
        x1: map.info().width(),
        y1: map.info().height(),
    };
    StreamTick {
        stamp_ns: tick.stamp_ns,
        robot: tick.pose,
        sensor: tick.pose,
        scan: tick.scan,
        changed: tick.report.changed,
        costs_changed: match tick.pending {
            None => tick.report.changed.map(around),
            Some(_) => Some(whole), // what was left by earlier ticks may lie anywhere
        },
    }
}
