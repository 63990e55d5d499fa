use horus_core::distance::{
    DistanceBuffers, DistanceCell, DistanceMap, DistanceOptions, EnvelopeVertex, UnknownAs,
};
use horus_core::prelude::{CellRect, Error};
use horus_host::reference::{signed_squared_distances, squared_distances};

use super::case::{Scene, window};

/// Distances in one of the four types.
pub(super) fn check_cell(
    cell: u8,
    scene: &Scene,
    cap: Option<u32>,
    unknown: bool,
    corners: [u16; 4],
    rows: u32,
) {
    let (width, height) = (scene.core.width(), scene.core.height());
    let window = window(corners, width, height);
    let options = DistanceOptions {
        max_squared: cap,
        unknown: if unknown {
            UnknownAs::Obstacle
        } else {
            UnknownAs::Clear
        },
    };
    let mask: Vec<bool> = scene
        .std
        .data
        .iter()
        .map(|v| *v >= 50 || unknown && *v < 0)
        .collect();
    let check = [check::<u16>, check::<i16>, check::<u32>, check::<i32>][usize::from(cell % 4)];
    check(scene, &mask, window, options, rows);
}

fn signed<D: DistanceCell>(cell: D) -> i64 {
    let squared = i64::from(cell.squared());
    if D::SIGNED && cell.is_obstacle() {
        -squared
    } else {
        squared
    }
}

fn check<D: DistanceCell>(
    scene: &Scene,
    mask: &[bool],
    window: CellRect,
    options: DistanceOptions,
    rows: u32,
) {
    let (width, height) = (scene.core.width(), scene.core.height());
    let cap = options.max_squared.unwrap_or(u32::MAX).min(D::MAX_SQUARED);
    let columns = width as usize;
    let expected: Vec<i64> = if D::SIGNED {
        signed_squared_distances(mask, columns.max(1), cap)
    } else {
        squared_distances(mask, columns.max(1), cap)
            .into_iter()
            .map(i64::from)
            .collect()
    };
    let mut cells = vec![D::default(); mask.len()];
    let mut vertices = vec![EnvelopeVertex::EMPTY; columns * if D::SIGNED { 2 } else { 1 }];
    let mut map = DistanceMap::new_in(DistanceBuffers {
        cells: &mut cells,
        vertices: &mut vertices,
    });
    map.compute(&scene.core, options).expect("buffers that fit");
    assert!(
        map.squared()
            .iter()
            .map(|d| signed(*d))
            .eq(expected.iter().copied()),
        "the whole map"
    );

    let begun = map.begin_window(&scene.core, window, options);
    if window.x1 > width || window.y1 > height {
        assert_eq!(begun, Err(Error::WindowOutside));
        assert_eq!(
            map.squared().len(),
            mask.len(),
            "a refused window changes nothing"
        );
        return;
    }
    begun.expect("buffers that fit");
    let mut steps = 0;
    while map.advance(rows.max(1)) > 0 {
        steps += 1;
        assert!(steps <= 2 * height && map.squared().is_empty());
    }
    for gy in 0..height {
        for gx in 0..width {
            let i = (gy * width + gx) as usize;
            let found = map.squared_at(gx, gy).map(signed);
            assert_eq!(
                found,
                window.contains(gx, gy).then_some(expected[i]),
                "{gx} {gy} in {window:?}"
            );
            nearest(scene, mask, &map, (gx, gy), cap);
        }
    }
}

/// The nearest obstacle is the first of those that no other is nearer than, unless it is beyond the cap.
fn nearest<D: DistanceCell>(
    scene: &Scene,
    mask: &[bool],
    map: &DistanceMap<'_, D>,
    (gx, gy): (u32, u32),
    cap: u32,
) {
    let width = scene.core.width();
    let obstacles = (0..).zip(mask).filter(|(_, obstacle)| **obstacle);
    let places = obstacles.map(|(i, _)| {
        let (x, y) = (i % width, i / width);
        (x.abs_diff(gx).pow(2) + y.abs_diff(gy).pow(2), y, x)
    });
    let expected = places.min().filter(|(squared, ..)| *squared <= cap);
    let expected = expected.filter(|_| map.squared_at(gx, gy).is_some());
    let found = map.nearest_obstacle(&scene.core, gx, gy);
    assert_eq!(found, expected.map(|(_, y, x)| (x, y)), "nearest to {gx} {gy}");
}
