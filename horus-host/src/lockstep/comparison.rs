//! Finding the cells in which two maps differ, and showing them.

use std::fmt::{Display, Write};

use super::{Layer, Layers, Mismatch};
use crate::picture::ascii_window;

/// Cells shown on each side of the first one that differs.
const PICTURE_RADIUS: u32 = 6;

/// How the two maps differ after a tick.
pub(super) struct Comparison {
    /// Number of differing cells in both layers; all of them where the sizes differ.
    pub differing: u64,
    /// The first of them in occupancy or else in cost.
    pub first: Option<Mismatch>,
}

/// Compares every cell of both layers. `lethal_cost` is for the picture only.
pub(super) fn compare(
    core: &Layers,
    std: &Layers,
    width: u32,
    lethal_cost: u8,
    at: (u64, u64),
) -> Comparison {
    let cell = |value: i8| match value {
        ..0 => '?',
        0 => '.',
        1..50 => '-',
        50..100 => '+',
        100.. => '#',
    };
    let cost = |value: u8| match value {
        255 => '?',
        0 => '.',
        value if value == lethal_cost => '#',
        value => char::from(b'0' + value / 26), // 1 to 254 become 0 to 9
    };
    let occupancy = differences(&core.occupancy, &std.occupancy);
    let costs = differences(&core.costs, &std.costs);
    let first = if occupancy > 0 {
        first_difference(Layer::Occupancy, &core.occupancy, &std.occupancy, width, at, cell)
    } else if costs > 0 {
        first_difference(Layer::Cost, &core.costs, &std.costs, width, at, cost)
    } else {
        None
    };
    Comparison {
        differing: occupancy + costs,
        first,
    }
}

fn differences<T: PartialEq>(core: &[T], std: &[T]) -> u64 {
    if core == std {
        return 0;
    }
    let pairs = core.iter().zip(std).filter(|(a, b)| a != b).count();
    (pairs + core.len().abs_diff(std.len())) as u64
}

fn first_difference<T: Copy + PartialEq + Display>(
    layer: Layer,
    core: &[T],
    std: &[T],
    width: u32,
    (tick, stamp_ns): (u64, u64),
    character: impl Fn(T) -> char,
) -> Option<Mismatch> {
    let index = core.iter().zip(std).position(|(a, b)| a != b)?;
    let columns = width.max(1) as usize;
    let cell = ((index % columns) as u32, (index / columns) as u32);
    let height = (core.len().min(std.len()) / columns) as u32;
    let at = |gx: u32, gy: u32| gy as usize * columns + gx as usize;
    let mut picture = String::new();
    let mut window = |name: &str, character: &dyn Fn(usize) -> char| {
        let text = ascii_window(width, height, cell, PICTURE_RADIUS, |gx, gy| {
            character(at(gx, gy))
        });
        let _ = writeln!(picture, "{name}:\n{}", text.trim_end());
    };
    let show = |values: &[T], i: usize| values.get(i).map_or(' ', |&value| character(value));
    window("core", &|i| show(core, i));
    window("std", &|i| show(std, i));
    window("different (x)", &|i| {
        if core.get(i) == std.get(i) { '.' } else { 'x' }
    });
    Some(Mismatch {
        layer,
        tick,
        stamp_ns,
        cell: Some(cell),
        core: core.get(index)?.to_string(),
        std: std.get(index)?.to_string(),
        picture,
    })
}
