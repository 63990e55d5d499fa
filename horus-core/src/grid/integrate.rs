//! Scan integration: no float operation, trigonometry or table per cell.

use nalgebra::Vector2;

use super::scan::Beam;
use super::workspace::Prepared;
use super::{BeamSlot, FREE, LaserScan, OCCUPIED, ScanModel, ScanReport, ScanWorkspace, UNKNOWN};
use crate::error::Error;
use crate::geometry::{CellRect, GridInfo, Pose2D};
use crate::math;
use crate::walk::{End, GridWalk, Tie};

/// Is told of every cell whose value differs from before the scan, each once.
pub(crate) trait ChangeSink {
    fn changed(&mut self, gx: u32, gy: u32);
    /// Smallest rectangle of the cells told so far.
    fn rect(&self) -> Option<CellRect>;
}

/// A hit cell waits for its mark as `old value + HIT`, which no legal value equals.
const HIT: i8 = UNKNOWN - i8::MIN;

#[inline]
fn is_waiting(value: i8) -> bool {
    value < UNKNOWN
}

pub(crate) fn integrate(
    cells: &mut [i8],
    info: &GridInfo,
    scan: &LaserScan<'_>,
    sensor: Pose2D,
    model: ScanModel,
    workspace: &mut ScanWorkspace<'_>,
    sink: &mut impl ChangeSink,
) -> Result<ScanReport, Error> {
    scan.validate()?;
    model.validate()?;
    if !sensor.is_finite() {
        return Err(Error::NonFinitePose);
    }
    let words = match model {
        ScanModel::Set => 0,
        ScanModel::Accumulate { .. } => info.cells().div_ceil(32),
    };
    let Prepared { slots, seen } = workspace.prepare(scan, words)?;
    let mut beams = Beams {
        info,
        scan,
        slots,
        start: info.world_to_cell(sensor.x, sensor.y),
        sensor,
        cos_sin: math::cos_sin(sensor.theta),
    };
    beams.find_hits();
    let (hits, misses) = match model {
        ScanModel::Set => set(cells, &beams, sink),
        ScanModel::Accumulate { hit, miss, min, max } => {
            let step = Step {
                min: i32::from(min),
                max: i32::from(max),
            };
            accumulate(cells, &beams, (hit, miss, step), seen, sink)
        }
    };
    let ignored = beams.slots.len() as u32 - hits - misses;
    Ok(ScanReport {
        changed: sink.rect(),
        hits,
        misses,
        ignored,
    })
}

/// The beams of one scan in the grid's window.
struct Beams<'a> {
    info: &'a GridInfo,
    scan: &'a LaserScan<'a>,
    slots: &'a mut [BeamSlot],
    sensor: Pose2D,
    /// Cell of the sensor; `None` if it is too far away for any beam.
    start: Option<(i32, i32)>,
    cos_sin: (f32, f32),
}

impl Beams<'_> {
    /// The cell a beam ends in.
    #[inline]
    fn end(&self, direction: &Vector2<f32>, range: f32) -> Option<(i32, i32)> {
        let (c, s) = self.cos_sin;
        let dx = c * direction.x - s * direction.y;
        let dy = s * direction.x + c * direction.y;
        self.info
            .world_to_cell(self.sensor.x + dx * range, self.sensor.y + dy * range)
    }

    /// Notes in its slot which cell of the map each beam hits.
    fn find_hits(&mut self) {
        for i in 0..self.slots.len() {
            let (Some(slot), Some(&range)) = (self.slots.get(i), self.scan.ranges.get(i)) else {
                return;
            };
            let hit = match (self.start, self.scan.beam(range)) {
                (Some(_), Beam::Hit) => self.end(&slot.direction, range),
                _ => None,
            };
            let cell = hit.and_then(|(cx, cy)| self.info.index(cx as u32, cy as u32));
            if let Some(slot) = self.slots.get_mut(i) {
                slot.hit = cell.map_or(BeamSlot::NO_CELL, |i| i as u32);
            }
        }
    }

    /// Every cell of the map that a beam hits.
    fn hits(&self) -> impl Iterator<Item = usize> + '_ {
        self.slots
            .iter()
            .map(|slot| slot.hit)
            .filter(|cell| *cell != BeamSlot::NO_CELL)
            .map(|cell| cell as usize)
    }

    /// Every cell that a beam clears, as often as beams do; returns the hits and the misses.
    #[inline]
    fn for_each_cleared(&self, mut visit: impl FnMut(usize)) -> (u32, u32) {
        let (mut hits, mut misses) = (0, 0);
        let Some(start) = self.start else {
            return (hits, misses);
        };
        let (width, height) = (self.info.width(), self.info.height());
        for (slot, &range) in self.slots.iter().zip(self.scan.ranges) {
            let (range, last, count) = match self.scan.beam(range) {
                Beam::Hit => (range, End::Excluded, &mut hits),
                Beam::Miss => (self.scan.range_max, End::Included, &mut misses),
                Beam::Ignored => continue,
            };
            let end = if slot.hit == BeamSlot::NO_CELL {
                self.end(&slot.direction, range)
            } else {
                let (gx, gy) = self.cell(slot.hit as usize);
                Some((gx as i32, gy as i32))
            };
            let Some(end) = end else {
                continue;
            };
            *count += 1;
            if let Some(walk) = GridWalk::new(start, end, Tie::Far, last, (width, height)) {
                walk.for_each(&mut visit);
            }
        }
        (hits, misses)
    }

    /// Column and row of a linear index.
    fn cell(&self, i: usize) -> (u32, u32) {
        let (i, width) = (i as u32, self.info.width().max(1));
        (i % width, i / width)
    }
}

/// Hits wait in their cells while beams clear around them; so a cell that is cleared and marked
/// again is written once, and only net changes are told.
fn set(cells: &mut [i8], beams: &Beams<'_>, sink: &mut impl ChangeSink) -> (u32, u32) {
    let mut changed = |i: usize| {
        let (gx, gy) = beams.cell(i);
        sink.changed(gx, gy);
    };
    for i in beams.hits() {
        if let Some(cell) = cells.get_mut(i)
            && !is_waiting(*cell)
        {
            *cell = cell.wrapping_sub(HIT);
        }
    }
    let counts = beams.for_each_cleared(|i| {
        if let Some(cell) = cells.get_mut(i)
            && *cell != FREE
            && !is_waiting(*cell)
        {
            *cell = FREE;
            changed(i);
        }
    });
    for i in beams.hits() {
        if let Some(cell) = cells.get_mut(i)
            && is_waiting(*cell)
        {
            if cell.wrapping_add(HIT) != OCCUPIED {
                changed(i);
            }
            *cell = OCCUPIED;
        }
    }
    counts
}

/// Limits of an accumulating step.
#[derive(Clone, Copy)]
struct Step {
    min: i32,
    max: i32,
}

impl Step {
    /// Where unknown cells start.
    const START: i32 = 50;

    fn apply(self, value: i8, by: i8) -> i8 {
        let from = if value < 0 { Self::START } else { i32::from(value) };
        (from + i32::from(by)).max(self.min).min(self.max) as i8
    }
}

fn accumulate(
    cells: &mut [i8],
    beams: &Beams<'_>,
    (hit, miss, step): (i8, i8, Step),
    seen: &mut [u32],
    sink: &mut impl ChangeSink,
) -> (u32, u32) {
    let mut take = |i: usize, by: i8| {
        let bit = 1 << (i % 32);
        let Some(word) = seen.get_mut(i / 32) else {
            return;
        };
        if *word & bit != 0 {
            return;
        }
        *word |= bit;
        if let Some(cell) = cells.get_mut(i) {
            let new = step.apply(*cell, by);
            if core::mem::replace(cell, new) != new {
                let (gx, gy) = beams.cell(i);
                sink.changed(gx, gy);
            }
        }
    };
    beams.hits().for_each(|i| take(i, hit));
    beams.for_each_cleared(|i| take(i, miss))
}
