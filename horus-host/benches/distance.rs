//! Exact distances, rays and free cells.
//!
//! `cargo bench -p horus-host --bench distance` prints thread CPU time (medians) and, for rays and free cells, the ratio
//! to a plain indexed loop in the same run. With `HORUS_PEER_PYTHON` naming a Python that has OpenCV and numpy, OpenCV's
//! precise distance transform runs on the same maps in between (`benches/peers/opencv_distance.py`); the sums of all
//! squared distances must be equal, and ours must be twice as fast.

use std::hint::black_box;
use std::path::PathBuf;
use std::process::{Command, ExitCode};

use cpu_time::ThreadTime;
use horus_core::distance::{DistanceBuffers, DistanceCell, DistanceMap, DistanceOptions, EnvelopeVertex};
use horus_core::grid::{GridView, OccupancyGrid2d, TrinaryValues};
use horus_core::nalgebra::{Isometry2, UnitComplex, Vector2};
use horus_core::prelude::Pose2D;
use horus_core::raycast::{RayCaster, WalkRule};

/// Ours must be faster than OpenCV by this.
const FACTOR: f64 = 2.0;
/// A ray or an iterator may take so many times as long as a plain loop.
const OVERHEAD: f64 = 1.2;

/// The median of some passes, in microseconds of thread CPU time.
fn median(passes: usize, mut operation: impl FnMut()) -> f64 {
    let mut times: Vec<f64> = (0..passes)
        .map(|_| {
            let start = ThreadTime::now();
            operation();
            start.elapsed().as_secs_f64() * 1e6
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[passes / 2]
}

/// A square map: 1 where an obstacle is.
struct Map {
    name: &'static str,
    side: u32,
    cells: Vec<u8>,
}

impl Map {
    /// One obstacle per 4000 cells.
    fn sparse(side: u32) -> Self {
        Self::random("sparse", side, 4000)
    }

    /// One obstacle per 50 cells.
    fn noise(side: u32) -> Self {
        Self::random("2 % random", side, 50)
    }

    fn random(name: &'static str, side: u32, one_in: u32) -> Self {
        let mut random = 0x2545_f491_u32;
        let mut next = || {
            random ^= random << 13;
            random ^= random >> 17;
            random ^= random << 5;
            u8::from((random >> 8).is_multiple_of(one_in))
        };
        let cells = (0..side * side).map(|_| next()).collect();
        Self { name, side, cells }
    }

    /// Rooms of 80 cells with doors.
    fn walls(side: u32) -> Self {
        let wall = |x: u32, y: u32| x % 80 == 40 && !(10..22).contains(&(y % 80)) || x == 0 || x == side - 1;
        let cell = |i: u32| u8::from(wall(i % side, i / side) || wall(i / side, i % side));
        Self {
            name: "walls",
            side,
            cells: (0..side * side).map(cell).collect(),
        }
    }

    /// Microseconds of a computation, and the sum of its squared distances.
    fn compute<D: DistanceCell>(&self) -> (f64, u64) {
        let values: Vec<i8> = self.cells.iter().map(|c| 100 * *c as i8).collect();
        let grid = GridView::new(
            &values,
            self.side,
            self.side,
            0.05,
            Pose2D::default(),
            TrinaryValues,
        );
        let grid = grid.expect("a legal map");
        let mut cells = vec![D::default(); values.len()];
        let mut vertices = vec![EnvelopeVertex::EMPTY; self.side as usize];
        let mut map = DistanceMap::new_in(DistanceBuffers {
            cells: &mut cells,
            vertices: &mut vertices,
        });
        let passes = 11.max(8_000_000 / values.len());
        let time = median(passes, || {
            let options = black_box(DistanceOptions::default());
            map.compute(&grid, options).expect("buffers that fit");
        });
        let sum = map.squared().iter().map(|d| u64::from(d.squared())).sum();
        (time, sum)
    }

    /// The same by OpenCV.
    fn peer(&self, python: &str) -> Result<(f64, u64), String> {
        let name = format!("horus-distance-{}-{}.bin", std::process::id(), self.side);
        let input: PathBuf = std::env::temp_dir().join(name);
        let mut bytes = self.side.to_le_bytes().to_vec();
        bytes.extend(&self.cells);
        std::fs::write(&input, bytes).map_err(|error| error.to_string())?;
        let script = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/peers/opencv_distance.py");
        let output = Command::new(python).arg(script).arg(&input).output();
        let _ = std::fs::remove_file(&input);
        let output = output.map_err(|error| format!("{python}: {error}"))?;
        let text = String::from_utf8_lossy(&output.stdout);
        let words: Vec<_> = text.split_whitespace().collect();
        let told = match words[..] {
            [time, sum] => time.parse().ok().zip(sum.parse().ok()),
            _ => None,
        };
        told.ok_or_else(|| format!("{python}: {}", String::from_utf8_lossy(&output.stderr)))
    }
}

fn distances(python: Option<&str>) -> bool {
    let mut reached = true;
    for side in [200, 1000] {
        for map in [Map::sparse(side), Map::noise(side), Map::walls(side)] {
            let (first, sum) = map.compute::<u32>();
            let peer = python.map(|python| map.peer(python));
            let (second, _) = map.compute::<u32>();
            let own = first.min(second);
            let (near, _) = map.compute::<u16>();
            println!(
                "distances, {side}x{side}, {}: u32 {own:.1} us, u16 {near:.1} us",
                map.name
            );
            match peer {
                None => {}
                Some(Err(error)) => {
                    eprintln!("the peer did not run: {error}");
                    reached = false;
                }
                Some(Ok((time, peer_sum))) => {
                    let (factor, same) = (time / own, sum == peer_sum);
                    let said = if same { "equal" } else { "DIFFERENT" };
                    println!("  OpenCV, precise: {time:.1} us, {factor:.2} times as long; sums {said}");
                    reached &= factor >= FACTOR && same;
                }
            }
        }
    }
    reached
}

/// Rays of 10 m at 5 cm from the middle of an empty map, against Beluga's walk written out on indices.
fn rays() -> bool {
    const SIDE: i32 = 500;
    const RAYS: u32 = 360;
    let cells = vec![0_i8; (SIDE * SIDE) as usize];
    let grid = GridView::new(
        &cells,
        SIDE as u32,
        SIDE as u32,
        0.05,
        Pose2D::default(),
        TrinaryValues,
    );
    let grid = grid.expect("a legal map");
    let (x, y) = (12.52_f32, 12.53);
    let bearings: Vec<_> = (0..RAYS)
        .map(|i| UnitComplex::new((i as f32).to_radians()))
        .collect();
    let rays = RayCaster::new(
        &grid,
        Isometry2::new(Vector2::new(x, y), 0.0),
        10.0,
        WalkRule::Standard,
    );
    let cast = || {
        bearings
            .iter()
            .filter(|bearing| rays.cast(**bearing).is_some())
            .count()
    };
    let plain = || {
        let cell = |p: f32| (p / 0.05).floor() as i32;
        let hit = |bearing: &&UnitComplex<f32>| {
            let (mut cx, mut cy) = (cell(x), cell(y));
            let (ex, ey) = (cell(x + 10.0 * bearing.re), cell(y + 10.0 * bearing.im));
            let (ax, ay) = ((ex - cx).abs(), (ey - cy).abs());
            let (sx, sy) = ((ex - cx).signum(), (ey - cy).signum());
            let (n, m) = (ax.max(ay), ax.min(ay));
            let mut err = n;
            for _ in 0..=n {
                if cx < 0 || cy < 0 || cx >= SIDE || cy >= SIDE {
                    return false;
                }
                if cells[(cy * SIDE + cx) as usize] != 0 {
                    return true;
                }
                err += 2 * m;
                let minor = err > 2 * n;
                err -= if minor { 2 * n } else { 0 };
                cx += if ax >= ay || minor { sx } else { 0 };
                cy += if ax < ay || minor { sy } else { 0 };
            }
            false
        };
        bearings.iter().filter(hit).count()
    };
    compare("360 casts of 10 m", cast, plain)
}

fn free_cells() -> bool {
    let map = Map::noise(1000);
    let values: Vec<i8> = map.cells.iter().map(|c| 100 * *c as i8).collect();
    let grid =
        GridView::new(&values, 1000, 1000, 0.05, Pose2D::default(), TrinaryValues).expect("a legal map");
    // A sum that needs every index, so that neither loop is left out.
    let listed = || grid.free_cells().fold(0_usize, |sum, i| sum ^ i);
    #[allow(
        clippy::needless_range_loop,
        reason = "the loop that the iterator is held against"
    )]
    let plain = || {
        let mut sum = 0;
        for i in 0..values.len() {
            if values[i] == 0 {
                sum ^= i;
            }
        }
        sum
    };
    compare("free_cells of 1000x1000", listed, plain)
}

/// Alternates two ways to the same result; prints and judges their ratio.
fn compare(name: &str, ours: impl Fn() -> usize, plain: impl Fn() -> usize) -> bool {
    assert_eq!(ours(), plain(), "{name}");
    let mut best = [f64::INFINITY; 2];
    for _ in 0..5 {
        best[0] = best[0].min(median(41, || {
            black_box(ours());
        }));
        best[1] = best[1].min(median(41, || {
            black_box(plain());
        }));
    }
    let ratio = best[0] / best[1];
    println!(
        "{name}: {:.1} us, a plain loop {:.1} us, ratio {ratio:.2}",
        best[0], best[1]
    );
    ratio <= OVERHEAD
}

fn main() -> ExitCode {
    let python = std::env::var("HORUS_PEER_PYTHON").ok();
    let reached = [distances(python.as_deref()), rays(), free_cells()];
    if reached.iter().all(|reached| *reached) {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}
