//! A likelihood field, the sensor model of Monte Carlo localisation, written against the grid traits and the distance
//! map only: it runs on every map that is an `OccupancyGrid2d`.
//!
//! `cargo run --release -p horus-host --example likelihood_field` shows a lidar a room, scores poses around the true one
//! and prints where the score is highest.
//!
//! Source: Thrun, Burgard, Fox, *Probabilistic Robotics*, section 6.4; parameters as in Beluga's `LikelihoodFieldModel`.

use horus_core::distance::{DistanceBuffers, DistanceMap, DistanceOptions, EnvelopeVertex};
use horus_core::grid::{GridView, OccupancyGrid2d, TrinaryValues};
use horus_core::nalgebra::{Isometry2, Point2, UnitComplex, Vector2};
use horus_core::prelude::{Error, Pose2D};
use horus_core::raycast::{RayCaster, WalkRule};

/// How likely a measured point is.
#[derive(Clone, Copy, Debug)]
struct Params {
    /// Metres beyond which an obstacle counts as this far away.
    max_obstacle_distance: f32,
    /// The sensor's longest range, metres.
    max_range: f32,
    /// Weight of measurements that hit what is on the map.
    z_hit: f32,
    /// Weight of those that hit anything else.
    z_random: f32,
    /// Standard deviation of a hit, metres.
    sigma_hit: f32,
}

/// The likelihood of a measurement that ends in a cell, for every cell of a map.
struct LikelihoodField<'a, G> {
    map: &'a G,
    likelihoods: Vec<f32>,
    /// That of a measurement outside the map.
    outside: f32,
}

impl<'a, G: OccupancyGrid2d> LikelihoodField<'a, G> {
    fn new(map: &'a G, params: Params) -> Result<Self, Error> {
        let mut cells = vec![0_u32; map.size()];
        let mut vertices = vec![EnvelopeVertex::EMPTY; map.width() as usize];
        let mut distances = DistanceMap::new_in(DistanceBuffers {
            cells: &mut cells,
            vertices: &mut vertices,
        });
        let options = DistanceOptions::default();
        distances.compute(
            map,
            options.with_max_distance(params.max_obstacle_distance, map.resolution()),
        )?;

        let outside = params.z_random / params.max_range;
        let amplitude = params.z_hit / (params.sigma_hit * std::f32::consts::TAU.sqrt());
        let likelihood = |metres: f32| {
            let metres = metres.min(params.max_obstacle_distance);
            amplitude * (-metres * metres / (2.0 * params.sigma_hit * params.sigma_hit)).exp() + outside
        };
        Ok(Self {
            map,
            likelihoods: distances.metres().map(likelihood).collect(),
            outside,
        })
    }

    /// The likelihood of a measurement at a point of the map's frame.
    fn at(&self, point: Vector2<f32>) -> f32 {
        let cell = self.map.cell_near(self.map.local_from_global(point));
        let index = cell.and_then(|cell| self.map.index_at(cell));
        index.map_or(self.outside, |i| self.likelihoods[i])
    }

    /// How well points, seen from a pose, fit the map: 1 + the sum of the likelihoods' cubes.
    fn weight(&self, pose: &Isometry2<f32>, points: &[Point2<f32>]) -> f32 {
        let cubes = points.iter().map(|point| self.at((pose * point).coords).powi(3));
        1.0 + cubes.sum::<f32>()
    }
}

/// Ends of the rays that hit something, in the sensor's frame.
fn measure(map: &impl OccupancyGrid2d, pose: Isometry2<f32>, params: Params) -> Vec<Point2<f32>> {
    let rays = RayCaster::new(map, pose, params.max_range, WalkRule::Standard);
    let ends = (0..180).filter_map(|i| {
        let bearing = UnitComplex::new(f32::to_radians(2.0 * i as f32));
        rays.cast(bearing)
            .map(|range| Point2::from(bearing * Vector2::new(range, 0.0)))
    });
    ends.collect()
}

/// A room of 6 m x 4 m with a pillar and a table, at 5 cm.
fn room() -> (Vec<i8>, u32, u32) {
    let (width, height) = (120, 80);
    let occupied = |x: u32, y: u32| {
        let wall = x < 2 || y < 2 || x >= width - 2 || y >= height - 2;
        let pillar = (30..36).contains(&x) && (50..56).contains(&y);
        let table = (80..100).contains(&x) && (15..27).contains(&y);
        wall || pillar || table
    };
    let cells = (0..width * height).map(|i| if occupied(i % width, i / width) { 100 } else { 0 });
    (cells.collect(), width, height)
}

const PARAMS: Params = Params {
    max_obstacle_distance: 2.0,
    max_range: 8.0,
    z_hit: 0.5,
    z_random: 0.5,
    sigma_hit: 0.2,
};

/// The pose with the highest weight on a lattice around the true one, and how far apart they are in metres.
fn localise(map: &impl OccupancyGrid2d) -> Result<(Isometry2<f32>, f32), Error> {
    let truth = Isometry2::new(Vector2::new(1.3, 0.4), 0.7);
    let points = measure(map, truth, PARAMS);
    let field = LikelihoodField::new(map, PARAMS)?;
    let offsets = || (-5..=5).map(|i| i as f32 * 0.1);
    let poses =
        offsets().flat_map(|dx| offsets().flat_map(move |dy| offsets().map(move |turn| (dx, dy, turn))));
    let poses = poses
        .map(|(dx, dy, turn)| Isometry2::new(truth.translation.vector + Vector2::new(dx, dy), 0.7 + turn));
    let scored = poses.map(|pose| (pose, field.weight(&pose, &points)));
    let (best, _) = scored.max_by(|a, b| a.1.total_cmp(&b.1)).expect("poses");
    Ok((best, (best.translation.vector - truth.translation.vector).norm()))
}

fn main() -> Result<(), Error> {
    let (cells, width, height) = room();
    let map = GridView::new(
        &cells,
        width,
        height,
        0.05,
        Pose2D::new(-3.0, -2.0, 0.0),
        TrinaryValues,
    )?;
    let (best, error) = localise(&map)?;
    let at = best.translation.vector;
    println!(
        "best of 1331 poses: x {:.2} m, y {:.2} m, heading {:.2} rad",
        at.x,
        at.y,
        best.rotation.angle()
    );
    println!("{:.0} mm from the true one", error * 1e3);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn likelihoods_fall_with_the_distance_to_the_nearest_obstacle() {
        let mut cells = vec![0; 25];
        cells[12] = 100;
        let map = GridView::new(&cells, 5, 5, 0.5, Pose2D::new(0.0, 0.0, 0.0), TrinaryValues).unwrap();
        let field = LikelihoodField::new(&map, PARAMS).unwrap();
        for (i, likelihood) in field.likelihoods.iter().enumerate() {
            let (dx, dy) = ((i % 5) as f64 - 2.0, (i / 5) as f64 - 2.0);
            let d = (0.5 * dx.hypot(dy)).min(2.0);
            let expected = 0.5 / (0.2 * std::f64::consts::TAU.sqrt()) * (-d * d / 0.08).exp() + 0.5 / 8.0;
            assert!(
                (f64::from(*likelihood) - expected).abs() < 1e-6,
                "{i}: {likelihood} {expected}"
            );
        }
        assert_eq!(field.at(Vector2::new(-0.1, 0.0)), 0.5 / 8.0, "outside the map");
    }

    #[test]
    fn the_true_pose_fits_best() {
        let (cells, width, height) = room();
        let map = GridView::new(
            &cells,
            width,
            height,
            0.05,
            Pose2D::new(-3.0, -2.0, 0.0),
            TrinaryValues,
        )
        .unwrap();
        let (best, error) = localise(&map).unwrap();
        assert!(
            error < 0.08 && (best.rotation.angle() - 0.7).abs() < 0.05,
            "{best} {error}"
        );
    }
}
