use std::collections::BTreeMap;

use arbitrary::Arbitrary;
use horus_core::frames::{MIN_BUFFER, MapStream, StreamOptions, StreamTick};
use horus_core::prelude::*;

use crate::costmap::{Storage, Width};

/// A map and how it is streamed.
#[derive(Clone, Debug, Arbitrary)]
pub struct StreamSetup {
    width: u8,
    height: u8,
    keep: bool,
    preset: u8,
    buffer: u8,
    every: [u8; 3],
}

/// Something that happens to a map.
#[derive(Clone, Debug, Arbitrary)]
pub enum MapOp {
    /// A cell takes a value.
    Set(u8, u8, i8),
    /// Cells from a place on, in index order, take values.
    Fill(u16, Vec<i8>),
    /// The window moves by so many cells, after a tick.
    Move(i8, i8),
    /// The costs are updated, within a budget or not, and a tick is sent.
    Tick(Option<u8>),
    /// The next tick is a key tick.
    Key,
}

/// A map as a tick showed it.
#[derive(Debug, PartialEq)]
pub(super) struct Shown {
    pub offset: [i32; 2],
    pub cells: Vec<i8>,
    pub costs: Vec<u8>,
}

/// The stream of a map, and what it showed by the time of the tick.
pub(super) fn write(setup: &StreamSetup, ops: &[MapOp]) -> (Vec<u8>, BTreeMap<u64, Shown>) {
    let (width, height) = (u32::from(setup.width % 64) + 1, u32::from(setup.height % 64) + 1);
    let mut storage = Storage::<u8>::new((width, height), setup.keep, false, 0x5a);
    let (cells, buffers) = storage.split();
    let params = match setup.preset % 4 {
        0 => CostParams::default(),
        1 => CostParams::horus(),
        2 => CostParams::nav2(),
        _ => CostParams {
            inflate_unknown: true,
            ..CostParams::nav2()
        },
    };
    let grid = OccupancyGrid::new_in(cells, width, height, 0.05, Pose2D::default()).expect("it fits");
    let mut map = CostMap::new_in(grid, buffers, params).expect("it fits");
    let mut wire = Vec::new();
    let mut buffer = vec![0; MIN_BUFFER + 16 * usize::from(setup.buffer)];
    let [key_every, maps_every, checksum_every] = setup.every.map(|every| u32::from(every % 8));
    let options = StreamOptions {
        key_every,
        maps_every,
        checksum_every,
        ..StreamOptions::default()
    };
    let sink = |frame: &[u8]| wire.extend_from_slice(frame);
    let mut stream = MapStream::new_in(&mut buffer, sink, options).expect("the buffer is long enough");
    let mut shown = BTreeMap::new();
    let mut robot = Pose2D::default();
    let mut changed: Option<CellRect> = None;
    for op in ops {
        let costs_changed = match *op {
            MapOp::Set(gx, gy, value) => {
                set(&mut map, u32::from(gx), u32::from(gy), value, &mut changed);
                continue;
            }
            MapOp::Fill(start, ref values) => {
                for (i, value) in (u32::from(start)..).zip(values) {
                    set(&mut map, i % width, i / width, *value, &mut changed);
                }
                continue;
            }
            MapOp::Key => {
                stream.request_key();
                continue;
            }
            MapOp::Move(..) => None,
            MapOp::Tick(None) => map.update_costs(),
            MapOp::Tick(Some(extra)) => {
                let budget = map.min_budget() + 16 * u32::from(extra);
                map.update_costs_within(budget)
                    .expect("the budget is large enough")
                    .changed
            }
        };
        let stamp_ns = shown.len() as u64;
        let tick = StreamTick {
            stamp_ns,
            robot,
            sensor: robot,
            scan: LaserScan {
                angle_min: 0.0,
                angle_increment: 0.0,
                range_min: 0.0,
                range_max: 0.0,
                ranges: &[],
            },
            changed: changed.take(),
            costs_changed,
        };
        stream.tick(&map, &tick);
        shown.insert(stamp_ns, show(&map));
        if let MapOp::Move(dx, dy) = *op {
            let by = |cells: i8| f32::from(cells) * 0.05;
            robot = Pose2D::new(robot.x + by(dx), robot.y + by(dy), 0.0);
            map.recenter(robot).expect("it is near");
        }
    }
    (wire, shown)
}

fn set<F: Width>(map: &mut CostMap<'_, F>, gx: u32, gy: u32, value: i8, changed: &mut Option<CellRect>) {
    if map.set_occupancy(gx, gy, value) {
        let cell = CellRect {
            x0: gx,
            y0: gy,
            x1: gx + 1,
            y1: gy + 1,
        };
        *changed = Some(changed.map_or(cell, |changed| changed.union(&cell)));
    }
}

fn show<F: Width>(map: &CostMap<'_, F>) -> Shown {
    Shown {
        offset: map.info().offset(),
        cells: map.occupancy_grid().data().to_vec(),
        costs: match map.costs() {
            Some(kept) => kept.to_vec(),
            None => (0..map.info().height()).flat_map(|gy| map.row(gy)).collect(),
        },
    }
}
