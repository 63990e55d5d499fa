//! HORUS: points to cells and back.

use serde_json::Value;

use crate::subject::{Error, Grid, ON_BOUNDARY, centre_error, seen};
use crate::vectors::*;

/// Cells from a boundary beyond which every subject must agree with HORUS.
const CLEAR_OF_BOUNDARY: f64 = 2e-3;

/// One look-up of HORUS.
struct Lookup {
    grid: Value,
    point: [f64; 2],
    cell: Option<(u32, u32)>,
    /// The point in continuous cell coordinates of the unrotated grid.
    q: [f64; 2],
    places: [Place; 2],
}

/// Where a coordinate lies between the cell boundaries of its axis.
#[derive(Clone, Copy, PartialEq)]
enum Place {
    /// Clear of any boundary.
    Inside,
    /// On one, whose upper cell this is.
    Boundary(f64),
    /// Neither, or not a number.
    Unclear,
}

impl Place {
    /// The place of `local` metres along an axis. Boundaries are the multiples of the resolution as an f32, and those
    /// of the decimal number that was meant by it.
    fn of(local: f64, resolution: f32) -> Self {
        let decimal: f64 = resolution.to_string().parse().expect("a number");
        let q = local / f64::from(resolution);
        let distance = |q: f64| (q - q.round()).abs();
        if q.is_infinite() || distance(q) > CLEAR_OF_BOUNDARY {
            Self::Inside
        } else if distance(q).min(distance(local / decimal)) < ON_BOUNDARY {
            Self::Boundary(q.round())
        } else {
            Self::Unclear
        }
    }
}

impl Lookup {
    /// Every look-up whose point is the same to the subject.
    fn all() -> Vec<Self> {
        let mut lookups = Vec::new();
        for grid in vectors("horus", "world_to_grid.json")
            .iter()
            .flat_map(|v| items(&v["grids"]))
        {
            let mut header = grid.clone();
            let cases = header["cases"].take();
            let resolution = f32_bits(&grid["resolution_f32_bits"]);
            let mut too_coarse = 0;
            for case in items(&cases) {
                let point = [0, 1].map(|i| f64_bits(&case[i]));
                let local = [0, 1].map(|i| point[i] - f64_bits(&grid["origin_f64_bits"][i]));
                let q = local.map(|l| l / f64::from(resolution));
                // Far outside, rounding cannot move a point into a map.
                let moved = |i: usize| {
                    q[i].abs() < 1e6 && (seen(point[i]) - point[i]).abs() > 1e-3 * f64::from(resolution.abs())
                };
                if moved(0) || moved(1) {
                    too_coarse += 1;
                    continue;
                }
                let cell = |c: &Value| (int(&c[0]) as u32, int(&c[1]) as u32);
                lookups.push(Self {
                    grid: header.clone(),
                    point,
                    cell: (!case[4].is_null()).then(|| cell(&case[4])),
                    q,
                    places: local.map(|l| Place::of(l, resolution)),
                });
            }
            if too_coarse > 0 {
                println!(
                    "skipped: {too_coarse} points on the map at {} are other points in 32-bit floats",
                    grid["origin"]
                );
            }
        }
        lookups
    }

    fn grid(&self, theta: f64) -> Result<Grid, Error> {
        let (width, height) = size_of(&self.grid);
        let [x, y] = self.origin();
        Grid::new(
            width,
            height,
            f32_bits(&self.grid["resolution_f32_bits"]),
            [x, y, theta],
        )
    }

    fn origin(&self) -> [f64; 2] {
        [0, 1].map(|i| f64_bits(&self.grid["origin_f64_bits"][i]))
    }

    fn theta(&self) -> f64 {
        f64_bits(&self.grid["origin_f64_bits"][2])
    }

    fn is_nan(&self) -> bool {
        self.point.iter().any(|v| v.is_nan())
    }

    fn is_inside_cells(&self) -> bool {
        self.places == [Place::Inside; 2]
    }
}

#[test]
fn horus_world_to_grid() {
    let mut compared = 0;
    for l in Lookup::all().iter().filter(|l| l.is_inside_cells()) {
        if let Ok(grid) = l.grid(0.0) {
            let got = grid.world_to_grid(l.point[0], l.point[1]);
            assert_eq!(got, l.cell, "{:?} on {}", l.point, l.grid);
            compared += 1;
        }
    }
    assert!(compared > 20, "only {compared} points compared");
}

#[test]
fn horus_deviation_a_point_on_a_boundary_belongs_to_the_upper_cell() {
    let (mut compared, mut different) = (0, 0);
    for l in Lookup::all() {
        if l.places.contains(&Place::Unclear) || l.is_inside_cells() {
            continue;
        }
        let Ok(grid) = l.grid(0.0) else { continue };
        let (width, height) = size_of(&l.grid);
        let axis = |i: usize, size: u32| {
            let k = match l.places[i] {
                Place::Boundary(k) => k,
                _ => l.q[i].floor(),
            };
            (k >= 0.0 && k < f64::from(size)).then_some(k as u32)
        };
        let expected = axis(0, width).zip(axis(1, height));
        let got = grid.world_to_grid(l.point[0], l.point[1]);
        assert_eq!(got, expected, "{:?} on {}", l.point, l.grid);
        compared += 1;
        different += usize::from(got != l.cell);
    }
    assert!(compared > 20 && different > 0, "{compared} points compared");
}

#[test]
fn horus_deviation_theta_is_applied() {
    let mut compared = 0;
    for l in Lookup::all().iter().filter(|l| l.is_inside_cells()) {
        let Ok(grid) = l.grid(l.theta()) else {
            continue;
        };
        if l.theta() != 0.0 && l.point.iter().all(|v| v.is_finite()) {
            // HORUS put the unrotated point there, so ours must put the rotated one there.
            let (x, y) = rotated(l.point, l.origin(), l.theta());
            assert_eq!(grid.world_to_grid(x, y), l.cell, "{:?} on {}", l.point, l.grid);
            compared += 1;
        }
    }
    assert!(compared > 5, "only {compared} points compared");
}

#[test]
fn horus_deviation_a_point_that_is_nan_is_outside() {
    let mut answered_by_horus = 0;
    for l in Lookup::all().iter().filter(|l| l.is_nan()) {
        if let Ok(grid) = l.grid(l.theta()) {
            assert_eq!(grid.world_to_grid(l.point[0], l.point[1]), None);
            answered_by_horus += usize::from(l.cell.is_some());
        }
    }
    assert!(answered_by_horus > 0);
}

#[test]
fn horus_deviation_an_impossible_geometry_is_an_error() {
    let mut refused = 0;
    for l in Lookup::all() {
        let resolution = f32_bits(&l.grid["resolution_f32_bits"]);
        let [x, y] = l.origin();
        let legal =
            resolution.is_finite() && resolution > 0.0 && [x, y, l.theta()].iter().all(|v| v.is_finite());
        assert_eq!(l.grid(l.theta()).is_ok(), legal, "{}", l.grid);
        refused += usize::from(!legal);
    }
    assert!(refused > 0);
}

#[test]
fn horus_grid_to_world_with_theta_applied() {
    for grid in vectors("horus", "grid_to_world.json")
        .iter()
        .flat_map(|v| items(&v["grids"]))
    {
        let (width, height) = size_of(grid);
        let [x0, y0, theta] = [0, 1, 2].map(|i| f64_bits(&grid["origin_f64_bits"][i]));
        let resolution = f32_bits(&grid["resolution_f32_bits"]);
        let made = |theta| Grid::new(width, height, resolution, [x0, y0, theta]);
        let (Ok(plain), Ok(turned)) = (made(0.0), made(theta)) else {
            println!("skipped: {} is an error here", grid["origin"]);
            continue;
        };
        let extent = x0.abs().max(y0.abs()) + f64::from(width.max(height)) * f64::from(resolution);
        for case in items(&grid["cases"]) {
            let (gx, gy) = (int(&case[0]) as u32, int(&case[1]) as u32);
            let cell = &case[2];
            let golden = (!cell.is_null()).then(|| [0, 1].map(|i| f64_bits(&cell[i])));
            let error = centre_error(extent);
            assert_near(plain.grid_to_world(gx, gy), golden.map(|[x, y]| (x, y)), error);
            let golden = golden.map(|point| rotated(point, [x0, y0], theta));
            assert_near(turned.grid_to_world(gx, gy), golden, error.max(1e-9));
        }
    }
}

fn assert_near(got: Option<(f64, f64)>, golden: Option<(f64, f64)>, error: f64) {
    let near = match (got, golden) {
        (Some((x, y)), Some((ex, ey))) => (x - ex).abs() <= error && (y - ey).abs() <= error,
        _ => got == golden,
    };
    assert!(near, "{got:?} instead of {golden:?}, at most {error} m off");
}

/// A point of the unrotated grid, on the grid turned by `theta` around its origin.
fn rotated(point: [f64; 2], origin: [f64; 2], theta: f64) -> (f64, f64) {
    let (sin, cos) = theta.sin_cos();
    let (dx, dy) = (point[0] - origin[0], point[1] - origin[1]);
    (
        origin[0] + (cos * dx - sin * dy),
        origin[1] + (sin * dx + cos * dy),
    )
}
