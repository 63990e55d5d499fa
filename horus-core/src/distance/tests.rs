//! Either kernel, whichever this build prefers, against looking from every cell at every other.

extern crate std;

use std::vec::Vec;

use super::*;
use crate::geometry::{CellRect, Pose2D};
use crate::grid::{GridView, TrinaryValues};

/// The signed squared distance of every cell.
fn brute_force(cells: &[i8], width: usize, cap: u32) -> Vec<i64> {
    let place = |i: usize| ((i % width) as i64, (i / width) as i64);
    let nearest = |i: usize| {
        let others = (0..cells.len()).filter(|o| cells[*o] != cells[i]);
        let squared = others.map(|o| (place(o).0 - place(i).0).pow(2) + (place(o).1 - place(i).1).pow(2));
        squared.min().unwrap_or(i64::MAX).min(cap.into()) * if cells[i] == 0 { 1 } else { -1 }
    };
    (0..cells.len()).map(nearest).collect()
}

fn check<D: DistanceCell>(cells: &[i8], width: u32, cap: u32) {
    let height = cells.len() as u32 / width;
    let grid = GridView::new(cells, width, height, 0.1, Pose2D::default(), TrinaryValues).unwrap();
    let expected = brute_force(cells, width as usize, cap.min(D::MAX_SQUARED));
    let mut distances = std::vec![D::default(); cells.len()];
    let mut vertices = std::vec![EnvelopeVertex::EMPTY; 2 * width as usize];
    let mut map = DistanceMap::new_in(DistanceBuffers {
        cells: &mut distances,
        vertices: &mut vertices,
    });
    let options = DistanceOptions {
        max_squared: Some(cap),
        ..DistanceOptions::default()
    };
    let whole = CellRect {
        x0: 0,
        y0: 0,
        x1: width,
        y1: height,
    };
    let part = CellRect {
        x0: width / 3,
        y0: height / 4,
        x1: width - width / 5,
        y1: height / 2 + 1,
    };
    for window in [whole, part] {
        map.compute_window(&grid, window, options).unwrap();
        for (i, expected) in expected.iter().enumerate() {
            let (gx, gy) = (i as u32 % width, i as u32 / width);
            let signed = |d: D| i64::from(d.squared()) * if d.is_obstacle() { -1 } else { 1 };
            let expected =
                window
                    .contains(gx, gy)
                    .then_some(if D::SIGNED { *expected } else { (*expected).max(0) });
            assert_eq!(
                map.squared_at(gx, gy).map(signed),
                expected,
                "{gx} {gy} of {width}x{height}, cap {cap}"
            );
        }
    }
}

#[test]
fn equals_brute_force() {
    let mut random = 0x2545_f491_u32;
    let mut next = || {
        random ^= random << 13;
        random ^= random >> 17;
        random ^= random << 5;
        random
    };
    for (width, height) in [(1, 1), (1, 9), (9, 1), (7, 5), (70, 12), (110, 20)] {
        for density in [0, 1, 3, 200, 1000] {
            let cells: Vec<i8> = (0..width * height)
                .map(|_| if next() % 1000 < density { 100 } else { 0 })
                .collect();
            for cap in [0, 1, 5, 400, 70_000, u32::MAX] {
                check::<u16>(&cells, width, cap);
                check::<i16>(&cells, width, cap);
                check::<u32>(&cells, width, cap);
                check::<i32>(&cells, width, cap);
            }
        }
    }
}
