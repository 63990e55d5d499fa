//! A room with a pillar, a robot that drives and jitters in it, and its two sensors, for both sides.

use horus_core::evidence::{
    BinaryThresholds, Flatscan, FusionOperator, FusionRule, Inpaint, InpaintFrame, Lattice,
    LocalMappingConfig, Masses, SensorConfig, SensorModel,
};
use horus_core::prelude::Pose2D;
use horus_host::reference::evidence as std_version;

/// A scan with its own numbers.
#[derive(Clone, Debug)]
pub struct OwnedScan {
    pub angles: Vec<f32>,
    pub ranges: Vec<f32>,
}

impl OwnedScan {
    pub fn borrowed(&self) -> Flatscan<'_> {
        Flatscan {
            angles: &self.angles,
            ranges: &self.ranges,
            invalid_range_threshold: 0.05,
            out_of_range_threshold: 4.0,
            visibilities: None,
        }
    }

    pub fn std(&self) -> std_version::Flatscan {
        std_version::Flatscan {
            angles: self.angles.clone(),
            ranges: self.ranges.clone(),
            invalid_range_threshold: 0.05,
            out_of_range_threshold: 4.0,
            visibilities: None,
        }
    }
}

/// Robot, world and noise.
pub struct Scene {
    noise: u32,
}

impl Scene {
    pub fn new(seed: u32) -> Self {
        Self { noise: seed | 1 }
    }

    pub fn next(&mut self) -> u32 {
        self.noise ^= self.noise << 13;
        self.noise ^= self.noise >> 17;
        self.noise ^= self.noise << 5;
        self.noise >> 8
    }

    /// A number of -1 to 1.
    pub fn jitter(&mut self) -> f32 {
        (self.next() % 2001) as f32 / 1000.0 - 1.0
    }

    /// The robot after so many ticks: on a bent path, with jitter.
    pub fn robot(&mut self, tick: u32) -> Pose2D {
        let t = tick as f32 * 0.1;
        let (x, y) = (1.5 * libm::sinf(0.31 * t), 1.2 * libm::cosf(0.23 * t));
        Pose2D::new(
            x + 0.01 * self.jitter(),
            y + 0.01 * self.jitter(),
            0.4 * t + 0.02 * self.jitter(),
        )
    }

    /// What a sensor with these beams sees from a pose in the world: walls of a 5 m room, a pillar, and now and then
    /// nothing usable.
    pub fn scan(&mut self, angles: &[f32], sensor: [f32; 3]) -> OwnedScan {
        let [x, y, yaw] = sensor;
        let ranges = angles.iter().map(|a| {
            let (s, c) = libm::sincosf(yaw + a);
            let wall = |at: f32, d: f32| {
                if d == 0.0 {
                    f32::INFINITY
                } else {
                    (2.5 * d.signum() - at) / d
                }
            };
            let room = wall(x, c).min(wall(y, s));
            let (px, py) = (0.9 - x, 0.6 - y);
            let (along, across) = (px * c + py * s, py * c - px * s);
            let pillar = if along > 0.0 && across.abs() < 0.2 {
                along - 0.1
            } else {
                f32::INFINITY
            };
            match self.next() % 53 {
                0 => f32::NAN,
                1 => f32::INFINITY,
                2 => 0.02,
                _ => room.min(pillar) + 0.01 * self.jitter(),
            }
        });
        let ranges = ranges.collect();
        OwnedScan {
            angles: angles.to_vec(),
            ranges,
        }
    }
}

/// A lidar all around and a fan of sonars.
pub fn angles() -> [Vec<f32>; 2] {
    let lidar = (0..180).map(|i| -3.1 + i as f32 * 0.034_9);
    let sonars = [-0.8f32, -0.3, 0.1, 0.6];
    [lidar.collect(), sonars.to_vec()]
}

pub fn sensors() -> [SensorConfig; 2] {
    let lattice = |rows, cols, cell, offset| Lattice::new(rows, cols, cell, offset, "robot").unwrap();
    [
        SensorConfig {
            lattice: lattice(72, 64, 0.05, [-0.5, -0.5]),
            mount: Pose2D::new(0.1, 0.02, 0.3),
            model: SensorModel::default(),
        },
        SensorConfig {
            lattice: Lattice {
                pose: Pose2D::new(-0.2, -0.9, 0.1),
                ..lattice(30, 36, 0.08, [0.0, -0.5])
            },
            mount: Pose2D::new(-0.1, 0.0, -0.2),
            model: SensorModel {
                m_free: Masses::known(0.35, 0.05).unwrap(),
                m_occ: Masses::known(0.0, 0.5).unwrap(),
                wall_thickness: 0.2,
                max_free_range: Some(1.5),
                beam_half_width: Some(0.15),
            },
        },
    ]
}

pub fn inpaint() -> [Inpaint; 2] {
    [
        Inpaint {
            frame: InpaintFrame::Robot,
            x: [-0.3, 0.3],
            y: [-0.2, 0.2],
            masses: Masses::known(1.0, 0.0).unwrap(),
        },
        Inpaint {
            frame: InpaintFrame::World,
            x: [0.5, 0.7],
            y: [-0.4, 0.1],
            masses: Masses::known(0.0, 0.8).unwrap(),
        },
    ]
}

/// The chain's configuration for core; the lattice is turned a little, and far from the world's origin.
pub fn config<'c>(
    operator: FusionOperator,
    sensors: &'c [SensorConfig],
    inpaint: &'c [Inpaint],
) -> LocalMappingConfig<'c> {
    LocalMappingConfig {
        lattice: Lattice::new(60, 56, 0.05, [-0.5, -0.5], "odom").unwrap(),
        rule: FusionRule::new(operator),
        sensors,
        inpaint,
        thresholds: BinaryThresholds::default(),
        max_distance: 1.0,
    }
}

fn std_lattice(lattice: &Lattice) -> std_version::Lattice {
    std_version::Lattice {
        rows: lattice.rows,
        cols: lattice.cols,
        cell_size: lattice.cell_size,
        pose: [lattice.pose.x, lattice.pose.y, lattice.pose.theta],
    }
}

pub fn std_masses(m: Masses) -> std_version::Masses {
    std_version::Masses::known(f64::from(m.free()), f64::from(m.occupied()))
}

/// The same for the std version.
pub fn std_config(config: &LocalMappingConfig<'_>) -> std_version::LocalMappingConfig {
    std_version::LocalMappingConfig {
        lattice: std_lattice(&config.lattice),
        operator: std_version::FusionOperator::from_name(config.rule.operator.as_str()).unwrap(),
        ignorance_floor: f64::from(config.rule.ignorance_floor),
        sensors: config
            .sensors
            .iter()
            .map(|s| std_version::Sensor {
                lattice: std_lattice(&s.lattice),
                mount: [s.mount.x, s.mount.y, s.mount.theta],
                model: std_version::SensorModel {
                    m_free: std_masses(s.model.m_free),
                    m_occ: std_masses(s.model.m_occ),
                    wall_thickness: s.model.wall_thickness,
                    max_free_range: s.model.max_free_range,
                    beam_half_width: s.model.beam_half_width,
                },
            })
            .collect(),
        inpaint: config
            .inpaint
            .iter()
            .map(|i| std_version::Inpaint {
                with_robot: i.frame == InpaintFrame::Robot,
                x: i.x,
                y: i.y,
                masses: std_masses(i.masses),
            })
            .collect(),
        thresholds: std_version::BinaryThresholds {
            free_threshold: f64::from(config.thresholds.free_threshold),
            occupied_threshold: f64::from(config.thresholds.occupied_threshold),
            is_optimistic: config.thresholds.is_optimistic,
        },
    }
}
