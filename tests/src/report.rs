//! Hashes of a scripted drive, full maps and the stream of frames included, so that two machines that
//! differ show which stage and tick differs first.

use core::cell::Cell;

use horus_core::costmap::FieldCell;
use horus_core::frames::{MIN_BUFFER, MapStream};
use horus_core::prelude::*;

use crate::drive::{self, Scenario};
use crate::hash::Hash;
use crate::rt::hprintln;
use crate::streaming;

/// Ticks between two reports.
const EVERY: u32 = 5;

/// One line of the report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    /// Which scenario.
    pub scenario: &'static str,
    /// Tick after which the hashes were taken.
    pub tick: u32,
    /// What was hashed: `scan`, `cells`, `costs`, `frames`, or a stage of local mapping.
    pub stage: &'static str,
    /// Its hash.
    pub hash: Hash,
}

/// Runs one scenario on `side` x `side` cells and shows every line of its report.
///
/// # Errors
/// As [`drive::run`].
pub fn run<F: FieldCell>(
    scenario: &Scenario,
    side: u32,
    storage: (&mut [i8], CostBuffers<'_, F>),
    workspace: &mut ScanWorkspace<'_>,
    mut show: impl FnMut(Line),
) -> Result<(), Error> {
    let frames = Cell::new(Hash::default());
    let sink = |frame: &[u8]| {
        let mut hash = frames.get();
        frame.iter().for_each(|byte| hash.byte(*byte));
        frames.set(hash);
    };
    let mut buffer = [0; MIN_BUFFER];
    let mut stream = MapStream::new_in(&mut buffer, sink, streaming::options(scenario))?;
    drive::run(scenario, side, storage, workspace, |map, tick| {
        stream.tick(map, &streaming::tick(map, tick));
        if tick.number % EVERY != EVERY - 1 {
            return;
        }
        let mut line = |stage, hash| {
            show(Line {
                scenario: scenario.name,
                tick: tick.number,
                stage,
                hash,
            })
        };
        let mut scan = Hash::default();
        tick.shift.into_iter().for_each(|by| scan.word(by as u32));
        let report = &tick.report;
        let counts = [report.hits, report.misses, report.ignored];
        counts
            .into_iter()
            .chain(tick.pending)
            .for_each(|word| scan.word(word));
        line("scan", scan);
        let mut cells = Hash::default();
        let values = map.occupancy_grid().data().iter();
        values.for_each(|value| cells.byte(*value as u8));
        line("cells", cells);
        let mut costs = Hash::default();
        (0..side).for_each(|gy| map.row(gy).for_each(|cost| costs.byte(cost)));
        line("costs", costs);
        line("frames", frames.get());
    })
}

/// Prints a line of a digest.
pub fn print(line: Line) {
    hprintln!(
        "{} | tick {} | {} | {:08x}",
        line.scenario,
        line.tick,
        line.stage,
        line.hash.0
    );
}

/// How a digest ended: `false`, and a last line that says why, after an error.
pub fn ended(result: Result<(), Error>) -> bool {
    if let Err(error) = result {
        hprintln!("digest: {}", error);
    }
    result.is_ok()
}
