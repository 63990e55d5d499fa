//! Distances and rays on a made-up map, repeated by `tests/c/distance.c` through the C interface: the same lines.

use horus_core::distance::{DistanceCell, DistanceMap, DistanceMapBuffers, DistanceOptions, UnknownAs};
use horus_core::nalgebra::UnitComplex;
use horus_core::prelude::*;
use horus_core::raycast::{RayCaster, WalkRule};

use crate::Arena;
use crate::hash::Hash;
use crate::made_up::next;
use crate::report::Line;

/// Columns of the map.
pub const WIDTH: u32 = 48;
/// Rows of the map.
pub const HEIGHT: u32 = 32;
const CELLS: usize = (WIDTH * HEIGHT) as usize;
/// Rays from every pose.
const RAYS: u32 = 48;

type Buffers<D> = DistanceMapBuffers<D, CELLS, { 2 * WIDTH as usize }>;

/// What the distances and rays take: the grid, and distances of any one type.
pub struct Storage {
    grid: [i8; CELLS],
    distances: Arena<{ size_of::<Buffers<i32>>() }>,
}

impl Storage {
    /// All bits zero.
    pub const fn empty() -> Self {
        Self {
            grid: [0; CELLS],
            distances: Arena::new(),
        }
    }
}

type Grid<'a> = OccupancyGrid<&'a mut [i8]>;

/// Mostly free; the upper part has no obstacle, so that the greatest distances are there.
fn fill(grid: &mut Grid<'_>) {
    let mut noise = 0x1234_5678;
    for gy in 0..HEIGHT {
        for gx in 0..WIDTH {
            let n = next(&mut noise) % 64;
            let value = match n {
                0..2 if gy < 20 => 100,
                2..4 => -1,
                _ => (n % 50) as i8,
            };
            grid.set_occupancy(gx, gy, value);
        }
    }
}

/// Distances of one type: of all cells, then of a window, computed seven rows at a time.
fn distances<D: DistanceCell>(
    grid: &Grid<'_>,
    buffers: &mut Buffers<D>,
    options: DistanceOptions,
) -> Result<Hash, Error> {
    let mut map = DistanceMap::new_in(buffers.split());
    let mut hash = Hash::default();
    let window = CellRect {
        x0: 12,
        y0: 6,
        x1: 39,
        y1: 28,
    };
    for window in [None, Some(window)] {
        match window {
            None => map.begin(grid, options)?,
            Some(window) => map.begin_window(grid, window, options)?,
        }
        while map.advance(7) > 0 {}
        let window = map.window();
        for gy in window.y0..window.y1 {
            for gx in window.x0..window.x1 {
                let cell = map.squared_at(gx, gy).unwrap_or_default();
                let squared = i64::from(cell.squared());
                let signed = if D::SIGNED && cell.is_obstacle() {
                    -squared
                } else {
                    squared
                };
                hash.word(signed as u32);
                hash.word((signed >> 32) as u32);
            }
            let gx = window.x0 + gy % window.width();
            hash.word(map.metres_at(gx, gy).unwrap_or_default().to_bits());
            let (x, y) = map.nearest_obstacle(grid, gx, gy).unwrap_or((u32::MAX, 0));
            hash.word(x);
            hash.word(y);
        }
    }
    Ok(hash)
}

fn rays(grid: &Grid<'_>, rule: WalkRule) -> Hash {
    let mut hash = Hash::default();
    for (x, y, theta) in [
        (2.0, 1.5, 0.5),
        (4.5, 3.0, -2.0),
        (0.1, 0.1, 0.75),
        (9.0, 9.0, 0.0),
    ] {
        let pose = Pose2D::new(x, y, theta).isometry();
        let rays = RayCaster::new(grid, pose, 2.5, rule);
        for i in 0..RAYS {
            let bearing = UnitComplex::new(i as f32 * 0.125);
            let cast = rays.cast(bearing);
            hash.byte(cast.is_some().into());
            hash.word(cast.unwrap_or(2.5).to_bits());
            for cell in rays.trace(bearing) {
                hash.word(cell.x as u32);
                hash.word(cell.y as u32);
            }
        }
    }
    hash
}

/// Computes everything and shows every line of the report.
///
/// # Errors
/// None that is not a defect.
pub fn run(storage: &mut Storage, mut show: impl FnMut(Line)) -> Result<(), Error> {
    let origin = Pose2D::new(-0.5, -0.25, 0.25);
    let mut grid = OccupancyGrid::new_in(&mut storage.grid[..], WIDTH, HEIGHT, 0.0625, origin)?;
    fill(&mut grid);
    let mut line = |stage, hash| {
        show(Line {
            scenario: "c: distances and rays",
            tick: 0,
            stage,
            hash,
        });
    };
    let arena = &mut storage.distances;
    let options = |max_squared, unknown| DistanceOptions {
        max_squared: Some(max_squared),
        unknown,
    };
    let (clear, obstacle) = (UnknownAs::Clear, UnknownAs::Obstacle);
    line(
        "u16",
        distances::<u16>(&grid, arena.zeroed(), options(400, clear))?,
    );
    line(
        "i16",
        distances::<i16>(&grid, arena.zeroed(), options(50, obstacle))?,
    );
    line(
        "u32",
        distances::<u32>(&grid, arena.zeroed(), options(u32::MAX, clear))?,
    );
    line(
        "i32",
        distances::<i32>(&grid, arena.zeroed(), options(1000, obstacle))?,
    );
    line("standard rays", rays(&grid, WalkRule::Standard));
    line("supercover rays", rays(&grid, WalkRule::Supercover));
    line("navground rays", rays(&grid, WalkRule::Navground));
    Ok(())
}
