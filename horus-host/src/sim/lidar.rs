//! The range finder.

use super::random::Random;
use super::{Disc, Pose, Segment, World};

/// A lidar that turns in the plane of the world.
///
/// Beam `i` points at `angle_min + i * angle_increment` in the sensor frame, computed in f64 from
/// the two f32 numbers that a `LaserScan` message would carry. All beams of a scan are taken at
/// one moment.
#[derive(Debug, Clone, PartialEq)]
pub struct Lidar {
    /// The number of beams.
    pub beams: usize,
    /// Direction of the first beam, in radians.
    pub angle_min: f32,
    /// Angle from one beam to the next, in radians.
    pub angle_increment: f32,
    /// Nearer obstacles read -inf; metres.
    pub range_min: f32,
    /// Obstacles at this distance or beyond read +inf; metres.
    pub range_max: f32,
    /// Standard deviation of the range, in metres.
    pub noise_sigma: f64,
    /// The probability that a beam is lost. A lost beam reads NaN or, as a speck of dust on the
    /// cover would make it, -inf, in equal shares.
    pub dropout: f64,
    /// The sensor's pose on the robot.
    pub mount: Pose,
}

impl Default for Lidar {
    /// 360 beams all round from -pi on, 0.12 to 8 m, 0.01 m of noise, 0.3 % of the beams lost,
    /// mounted 0.1 m ahead of the robot's centre.
    fn default() -> Self {
        Self {
            beams: 360,
            angle_min: -std::f32::consts::PI,
            angle_increment: std::f32::consts::TAU / 360.0,
            range_min: 0.12,
            range_max: 8.0,
            noise_sigma: 0.01,
            dropout: 0.003,
            mount: Pose {
                x: 0.1,
                y: 0.0,
                theta: 0.0,
            },
        }
    }
}

impl Lidar {
    /// The exact distances from the sensor to the nearest surface along each beam, in metres;
    /// infinite where there is none within `range_max`. `robot` is the robot's pose in the world,
    /// `people` stand in the way.
    ///
    /// # Complexity
    /// Beams times surfaces within `range_max`.
    pub fn distances(&self, world: &World, people: &[Disc], robot: &Pose) -> Vec<f64> {
        let sensor = robot.mounted(&self.mount);
        let at = (sensor.x, sensor.y);
        let reach = f64::from(self.range_max);
        let faces = |edge: &&Segment| is_in_front(edge, at) && edge.distance(at) <= reach;
        let edges: Vec<Segment> = world.edges().iter().filter(faces).copied().collect();
        let near = |disc: &&Disc| disc.distance(at) <= reach;
        let discs = world.discs().iter().chain(people).filter(near);
        let discs: Vec<Disc> = discs.copied().collect();

        let distance = |beam: usize| {
            let bearing = f64::from(self.angle_min) + beam as f64 * f64::from(self.angle_increment);
            let (sin, cos) = libm::sincos(sensor.theta + bearing);
            let to_edges = edges.iter().filter_map(|edge| edge.ray(at, (cos, sin)));
            let to_discs = discs.iter().filter_map(|disc| disc.ray(at, (cos, sin)));
            to_edges.chain(to_discs).fold(f64::INFINITY, f64::min)
        };
        let within = |distance: f64| {
            if distance < reach { distance } else { f64::INFINITY }
        };
        (0..self.beams).map(distance).map(within).collect()
    }

    /// One scan: [`Self::distances`] with noise and losses, in the terms of REP-117.
    pub(super) fn scan(&self, world: &World, people: &[Disc], robot: &Pose, random: &mut Random) -> Vec<f32> {
        let distances = self.distances(world, people, robot);
        let measure = |distance| self.measure(distance, random);
        distances.into_iter().map(measure).collect()
    }

    /// Draws the same number of random numbers whatever the distance, so that one obstacle more
    /// changes only the beams that see it.
    fn measure(&self, distance: f64, random: &mut Random) -> f32 {
        let (is_lost, is_invalid) = (random.chance(self.dropout), random.chance(0.5));
        let range = (distance + self.noise_sigma * random.gaussian()) as f32;
        if is_lost {
            if is_invalid { f32::NAN } else { f32::NEG_INFINITY }
        } else if range < self.range_min {
            f32::NEG_INFINITY
        } else if range >= self.range_max {
            f32::INFINITY
        } else {
            range
        }
    }
}

/// True if a point lies on the right of an edge, where its box is not.
fn is_in_front(edge: &Segment, (x, y): (f64, f64)) -> bool {
    let (ex, ey) = (edge.b.0 - edge.a.0, edge.b.1 - edge.a.1);
    ex * (y - edge.a.1) - ey * (x - edge.a.0) < 0.0
}
