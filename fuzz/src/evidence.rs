//! Target `evidence`: scans with any numbers into local mapping. Which cell a scan says what about must be
//! the std version's in every cell; masses must stay masses, and near the std version's.

use std::f32::consts::TAU;

use arbitrary::Arbitrary;
use horus_core::distance::{DistanceBuffers, EnvelopeVertex};
use horus_core::evidence::{
    BeamLimits, BinaryThresholds, EvidenceU16, Flatscan, FusionOperator, FusionRule, Lattice, LocalMapping,
    LocalMappingConfig, MappingBuffers, MassCell, Masses, ScanClass, SensorConfig, SensorModel, SensorScan,
    class_bytes,
};
use horus_core::prelude::Pose2D;
use horus_core::storage::bitmap_words;
use horus_host::reference::evidence as std_version;

use crate::number::Number;
use crate::sequence::{Rest, Short};

/// A beam: how far from the one before, what it measured, how far it could see.
#[derive(Arbitrary, Clone, Copy, Debug)]
struct Beam {
    gap: Number,
    range: Number,
    visibility: Number,
}

/// A tick: where the robot stands and what its sensor sees.
#[derive(Arbitrary, Debug)]
struct Tick {
    robot: [Number; 3],
    first: Number,
    beams: Short<Beam, 63>,
    is_full_turn: bool,
    thresholds: [Number; 2],
    has_visibilities: bool,
}

/// Sizes, parameters and ticks.
#[derive(Arbitrary, Debug)]
pub struct EvidenceCase {
    size: [u8; 2],
    operator: u8,
    lattice: [Number; 3],
    mount: [Number; 3],
    wall_thickness: Number,
    max_free_range: Option<Number>,
    beam_half_width: Option<Number>,
    masses: [u8; 4],
    ticks: Rest<Tick>,
}

fn pose([x, y, theta]: [Number; 3]) -> Pose2D {
    Pose2D::new(x.of(0.1), y.of(0.1), theta.of(0.1))
}

/// Runs one case; any broken promise panics.
pub fn run(case: &EvidenceCase) {
    let [rows, cols] = case.size.map(|side| u32::from(side % 24) + 1);
    let lattice = |pose| Lattice {
        rows,
        cols,
        cell_size: 0.1,
        pose,
        ..Lattice::default()
    };
    let mass = |i: usize| f32::from(case.masses[i]) / 255.0;
    let (Ok(m_free), Ok(m_occ)) = (Masses::known(mass(0), mass(1)), Masses::known(mass(2), mass(3))) else {
        return;
    };
    let sensors = [SensorConfig {
        lattice: lattice(pose(case.lattice)),
        mount: pose(case.mount),
        model: SensorModel {
            m_free,
            m_occ,
            wall_thickness: case.wall_thickness.of(0.1),
            max_free_range: case.max_free_range.map(|range| range.of(0.1)),
            beam_half_width: case.beam_half_width.map(|width| width.of(0.1)),
        },
    }];
    let operator = FusionOperator::ALL[usize::from(case.operator % 4)];
    let config = LocalMappingConfig {
        lattice: lattice(Pose2D::new(-0.05 * rows as f32, -0.05 * cols as f32, 0.0)),
        rule: FusionRule::new(operator),
        sensors: &sensors,
        inpaint: &[],
        thresholds: BinaryThresholds::default(),
        max_distance: 1.0,
    };
    let cells = (rows * cols) as usize;
    let mut masses = vec![EvidenceU16::VACUOUS; cells];
    let (mut classes, mut binary) = (
        vec![0; class_bytes(rows, cols)],
        vec![0; bitmap_words(rows, cols)],
    );
    let mut limits = vec![BeamLimits::EMPTY; 64];
    let (mut squared, mut vertices) = (vec![0u16; cells], vec![EnvelopeVertex::EMPTY; rows as usize]);
    let buffers = MappingBuffers {
        cells: &mut masses,
        classes: &mut classes,
        limits: &mut limits,
        binary: &mut binary,
        distance: DistanceBuffers {
            cells: &mut squared[..],
            vertices: &mut vertices[..],
        },
    };
    let Ok(mut core) = LocalMapping::new_in(buffers, config) else {
        return;
    };
    for tick in &case.ticks.0 {
        let before = (core.evidence().cells().to_vec(), *core.info());
        let (angles, ranges, visibilities) = beams(tick);
        let scan = Flatscan {
            angles: &angles,
            ranges: &ranges,
            invalid_range_threshold: tick.thresholds[0].of(0.01),
            out_of_range_threshold: tick.thresholds[1].of(0.1),
            visibilities: tick.has_visibilities.then_some(&visibilities[..]),
        };
        let scan = SensorScan { sensor: 0, scan };
        let Ok(report) = core.tick(&[scan], pose(tick.robot)) else {
            assert_eq!((core.evidence().cells().to_vec(), *core.info()), before);
            continue;
        };
        assert_eq!(report.distance_rows_left, 0);
        for cell in core.evidence().cells() {
            assert!(
                cell.free_steps().checked_add(cell.occupied_steps()).is_some(),
                "{cell:?}"
            );
        }
        check_classes(&core, &sensors[0], &scan.scan);
    }
}

fn beams(tick: &Tick) -> (Vec<f32>, Vec<f32>, Vec<f32>) {
    let mut angle = tick.first.of(0.1);
    // A full turn has its beams almost evenly all around, from wherever it begins.
    let (even, gap) = if tick.is_full_turn {
        (TAU / tick.beams.0.len() as f32, 1e-4)
    } else {
        (0.0, 0.02)
    };
    let mut beams = (Vec::new(), Vec::new(), Vec::new());
    for beam in &tick.beams.0 {
        beams.0.push(angle);
        beams.1.push(beam.range.of(0.1));
        beams.2.push(beam.visibility.of(0.1));
        angle += even + beam.gap.of(gap).abs();
    }
    beams
}

/// Compares what the last scan says about each cell with the definition.
fn check_classes(core: &LocalMapping<'_>, sensor: &SensorConfig, scan: &Flatscan<'_>) {
    let Lattice {
        rows,
        cols,
        cell_size,
        pose,
        ..
    } = sensor.lattice;
    let lattice = std_version::Lattice {
        rows,
        cols,
        cell_size,
        pose: [pose.x, pose.y, pose.theta],
    };
    let model = std_version::SensorModel {
        m_free: std_version::Masses::VACUOUS,
        m_occ: std_version::Masses::VACUOUS,
        wall_thickness: sensor.model.wall_thickness,
        max_free_range: sensor.model.max_free_range,
        beam_half_width: sensor.model.beam_half_width,
    };
    let scan = std_version::Flatscan {
        angles: scan.angles.to_vec(),
        ranges: scan.ranges.to_vec(),
        invalid_range_threshold: scan.invalid_range_threshold,
        out_of_range_threshold: scan.out_of_range_threshold,
        visibilities: scan.visibilities.map(<[f32]>::to_vec),
    };
    let mount = [sensor.mount.x, sensor.mount.y, sensor.mount.theta];
    let expected = std_version::classify(&scan, mount, &lattice, &model);
    for ((row, col), expected) in lattice.cells().zip(expected) {
        let same = match core.class_at(row, col) {
            ScanClass::Vacuous => std_version::ScanClass::Vacuous,
            ScanClass::Free => std_version::ScanClass::Free,
            ScanClass::Occupied => std_version::ScanClass::Occupied,
        };
        assert_eq!(same, expected, "cell ({row}, {col})");
    }
}
