//! A scripted drive of local mapping through a made-up room, and the hashes of its stages.

use horus_core::distance::DistanceCell;
use horus_core::evidence::{
    BinaryThresholds, Flatscan, FusionRule, Inpaint, InpaintFrame, Lattice, LocalMapping,
    LocalMappingBuffers, LocalMappingConfig, MappingBuffers, MassCell, Masses, SensorConfig, SensorModel,
    SensorScan, class_bytes,
};
use horus_core::prelude::*;
use horus_core::storage::bitmap_words;

use crate::hash::Hash;
use crate::report::Line;

/// Cells per side of the fused map and of the lidar's lattice.
pub const SIDE: u32 = 64;
/// Beams of the lidar.
const BEAMS: usize = 120;
const TICKS: u32 = 16;
/// Ticks between two reports.
const EVERY: u32 = 4;

/// Storage of one drive.
pub type Buffers<M, D> = LocalMappingBuffers<
    { (SIDE * SIDE) as usize },
    { class_bytes(SIDE, SIDE) },
    { bitmap_words(SIDE, SIDE) },
    BEAMS,
    { 2 * SIDE as usize },
    M,
    D,
>;

/// A lidar all around, and a sonar of one wide beam to the side.
fn sensors() -> Result<[SensorConfig; 2], Error> {
    let model = SensorModel::default();
    Ok([
        SensorConfig {
            lattice: Lattice::new(SIDE, SIDE, 0.05, [-0.5, -0.5], "robot")?,
            mount: Pose2D::new(0.1, -0.05, 0.2),
            model,
        },
        SensorConfig {
            lattice: Lattice::new(30, 36, 0.07, [0.0, -0.5], "robot")?,
            mount: Pose2D::new(0.0, 0.1, 0.9),
            model: SensorModel {
                m_free: Masses::new(0.3, 0.05, 0.65)?,
                max_free_range: Some(1.2),
                beam_half_width: Some(0.2),
                ..model
            },
        },
    ])
}

/// Drives, and shows the hash of each stage now and then.
///
/// # Errors
/// A rule that the cell type does not take.
pub fn run<M: MassCell, D: DistanceCell>(
    name: &'static str,
    rule: FusionRule,
    buffers: MappingBuffers<'_, M, D>,
    mut show: impl FnMut(Line),
) -> Result<(), Error> {
    let sensors = sensors()?;
    let inpaint = [Inpaint {
        frame: InpaintFrame::Robot,
        x: [-0.2, 0.25],
        y: [-0.2, 0.2],
        masses: Masses::new(1.0, 0.0, 0.0)?,
    }];
    let config = LocalMappingConfig {
        lattice: Lattice::new(SIDE, SIDE, 0.05, [-0.5, -0.5], "odom")?,
        rule,
        sensors: &sensors,
        inpaint: &inpaint,
        thresholds: BinaryThresholds::default(),
        max_distance: 1.5,
    };
    let mut mapping = LocalMapping::new_in(buffers, config)?;
    let (mut angles, mut ranges) = ([0.0; BEAMS], [0.0; BEAMS]);
    for (i, angle) in angles.iter_mut().enumerate() {
        // Denser ahead than behind.
        let even = i as f32 * (core::f32::consts::TAU / BEAMS as f32) - 3.1;
        *angle = even - 0.3 * libm::sinf(even);
    }
    let mut noise = 1;
    for tick in 0..TICKS {
        let t = tick as f32;
        let robot = Pose2D::new(0.11 * t, 0.4 * libm::sinf(0.3 * t), 0.13 * t);
        see(robot, &angles, &mut ranges, &mut noise);
        let lidar = Flatscan {
            angles: &angles,
            ranges: &ranges,
            invalid_range_threshold: 0.05,
            out_of_range_threshold: 3.0,
            visibilities: None,
        };
        let echo = [0.6 + 0.05 * t];
        let sonar = Flatscan {
            angles: &[0.0],
            ranges: &echo,
            ..lidar
        };
        let scans = [(0, lidar), (1, sonar)].map(|(sensor, scan)| SensorScan { sensor, scan });
        // The sonar ticks at half the rate.
        let due = scans.get(..1 + (tick as usize + 1) % 2).unwrap_or_default();
        let report = mapping.tick(due, robot)?;
        if tick % EVERY != EVERY - 1 {
            continue;
        }
        let mut line = |stage, hash| {
            show(Line {
                scenario: name,
                tick,
                stage,
                hash,
            })
        };
        let mut hash = Hash::default();
        report.shift.into_iter().for_each(|by| hash.word(by as u32));
        hash.word(report.fusion.conflicts);
        hash.word(report.fusion.conflict_mass.to_bits());
        line("fusion", hash);
        let mut hash = Hash::default();
        for cell in mapping.evidence().cells() {
            let masses = cell.masses();
            hash.word(masses.free().to_bits());
            hash.word(masses.occupied().to_bits());
        }
        line("evidence", hash);
        let mut hash = Hash::default();
        mapping.binary().words().iter().for_each(|word| hash.word(*word));
        line("binary", hash);
        let mut hash = Hash::default();
        mapping.distance().metres().for_each(|d| hash.word(d.to_bits()));
        line("distance", hash);
    }
    Ok(())
}

/// Ranges in a room, with noise and what is not usable.
fn see(robot: Pose2D, angles: &[f32], ranges: &mut [f32], noise: &mut u32) {
    let (x, y) = (robot.x - 0.8, robot.y);
    for (angle, range) in angles.iter().zip(ranges) {
        let (s, c) = libm::sincosf(robot.theta + angle);
        let wall = |at: f32, d: f32| {
            if d == 0.0 {
                f32::INFINITY
            } else {
                (1.6 * d.signum() - at) / d
            }
        };
        *noise ^= *noise << 13;
        *noise ^= *noise >> 17;
        *noise ^= *noise << 5;
        *range = match *noise >> 8 & 63 {
            0 => f32::NAN,
            1 => f32::INFINITY,
            jitter => wall(x, c).min(wall(y, s)) + jitter as f32 * 0.000_5,
        };
    }
}
