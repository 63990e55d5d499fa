//! How the scripted drives are streamed as frames.

use horus_core::frames::{StreamOptions, StreamTick};

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
pub fn tick<'a>(tick: &Tick<'a>) -> StreamTick<'a> {
    StreamTick {
        stamp_ns: tick.stamp_ns,
        robot: tick.pose,
        sensor: tick.pose,
        scan: tick.scan,
        changed: tick.report.changed,
        costs_changed: tick.costs_changed,
    }
}
