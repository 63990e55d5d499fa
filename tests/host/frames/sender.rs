//! A map that is streamed, and what a listener must see of it.

use std::cell::RefCell;

use horus_core::costmap::FieldCell;
use horus_core::frames::{MapStream, StreamOptions, StreamTick};
use horus_core::prelude::*;

use crate::op::Op;
use crate::pair::Pair;

/// A tick as it was sent.
#[derive(Clone, Debug, PartialEq)]
pub struct Sent {
    pub stamp_ns: u64,
    pub pose: [u32; 3],
    pub ranges: Vec<u32>,
    pub offset: [i32; 2],
    pub cells: Vec<i8>,
    pub costs: Vec<u8>,
    /// Bytes of the stream before the tick and after it.
    pub bytes: [usize; 2],
    pub is_key: bool,
}

/// The bits of a pose.
pub fn bits(pose: Pose2D) -> [u32; 3] {
    [pose.x, pose.y, pose.theta].map(f32::to_bits)
}

/// What has happened to the map since the last tick.
#[derive(Default)]
struct Since {
    changed: Option<CellRect>,
    costs_changed: Option<CellRect>,
    ranges: Vec<f32>,
}

fn join(a: Option<CellRect>, b: Option<CellRect>) -> Option<CellRect> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.union(&b)),
        (a, b) => a.or(b),
    }
}

/// Applies all operations, sends a tick after each update, and returns the stream and its ticks.
pub fn send<F: FieldCell>(
    pair: &mut Pair<'_, F>,
    ops: &[Op],
    options: StreamOptions<'_>,
    buffer: usize,
) -> (Vec<u8>, Vec<Sent>) {
    let wire = RefCell::new(Vec::new());
    let mut longest = 0;
    let mut buffer = vec![0; buffer];
    let capacity = buffer.len();
    let sink = |frame: &[u8]| {
        longest = longest.max(frame.len());
        wire.borrow_mut().extend_from_slice(frame);
    };
    let mut stream = MapStream::new_in(&mut buffer, sink, options).unwrap();
    let mut sent = Vec::new();
    let mut since = Since::default();
    let map = &mut pair.core;
    let mut robot = Pose2D::default();
    let resolution = map.info().resolution();
    for op in ops {
        let mut is_tick = false;
        match *op {
            Op::Set { gx, gy, value } => {
                if map.set_occupancy(gx, gy, value) {
                    since.changed = join(since.changed, Some(cell(gx, gy)));
                }
            }
            Op::Block { gx, gy, size, value } => {
                for (x, y) in (gy..gy + size).flat_map(|y| (gx..gx + size).map(move |x| (x, y))) {
                    if map.set_occupancy(x, y, value) {
                        since.changed = join(since.changed, Some(cell(x, y)));
                    }
                }
            }
            Op::Scan(ref scan) => {
                let core_scan = LaserScan {
                    angle_min: scan.angle_min,
                    angle_increment: scan.angle_increment,
                    range_min: 0.05,
                    range_max: 3.0,
                    ranges: &scan.ranges,
                };
                let pose = Pose2D::new(scan.x + robot.x, scan.y + robot.y, scan.theta);
                let report = map
                    .integrate_scan(&core_scan, pose, scan.model, &mut pair.workspace)
                    .unwrap();
                since.changed = join(since.changed, report.changed);
                since.ranges.clone_from(&scan.ranges);
            }
            // A rectangle of changes is in the indices of the window it was made in, so a tick
            // separates changes from motion, as in a control loop.
            Op::Move { dx, dy } => {
                robot = Pose2D::new(robot.x + dx * resolution, robot.y + dy * resolution, 0.3);
                is_tick = true;
            }
            Op::Jump { x, y } => {
                robot = Pose2D::new(x, y, -0.2);
                is_tick = true;
            }
            Op::Update => {
                since.costs_changed = join(since.costs_changed, map.update_costs());
                is_tick = true;
            }
            Op::UpdateWithin { extra, .. } => {
                let update = map.update_costs_within(map.min_budget() + extra).unwrap();
                since.costs_changed = join(since.costs_changed, update.changed);
                is_tick = true;
            }
        }
        if !is_tick {
            continue;
        }
        let number = sent.len() as u64;
        let Since {
            changed,
            costs_changed,
            ranges,
        } = std::mem::take(&mut since);
        let start = wire.borrow().len();
        let tick = StreamTick {
            stamp_ns: number * 1_000_000_007,
            robot,
            sensor: robot,
            scan: LaserScan {
                angle_min: -1.0,
                angle_increment: 0.1,
                range_min: 0.05,
                range_max: 3.0,
                ranges: &ranges,
            },
            changed,
            costs_changed,
        };
        if number % 7 == 6 {
            wire.borrow_mut().extend_from_slice("tick ü\r\n".as_bytes());
        }
        let is_key = stream.tick(map, &tick);
        sent.push(Sent {
            stamp_ns: tick.stamp_ns,
            pose: bits(robot),
            ranges: ranges.iter().map(|range| range.to_bits()).collect(),
            offset: map.info().offset(),
            cells: map.occupancy_grid().data().to_vec(),
            // Kept bytes show the last update, the others the present.
            costs: match map.costs() {
                Some(kept) => kept.to_vec(),
                None => (0..map.info().height())
                    .flat_map(|gy| map.row(gy).collect::<Vec<_>>())
                    .collect(),
            },
            bytes: [start, wire.borrow().len()],
            is_key,
        });
        if matches!(op, Op::Move { .. } | Op::Jump { .. }) {
            map.recenter(robot).unwrap(); // told by the next tick
        }
    }
    assert!(longest <= capacity);
    (wire.into_inner(), sent)
}

fn cell(gx: u32, gy: u32) -> CellRect {
    CellRect {
        x0: gx,
        y0: gy,
        x1: gx + 1,
        y1: gy + 1,
    }
}
