//! Scans over a full turn, or nearly, that begin anywhere: every cell's class is the definition's.

use std::f32::consts::{PI, TAU};

use horus_core::evidence::{BeamLimits, Flatscan, Lattice, ScanClass, SensorGrid, SensorModel, class_bytes};
use horus_core::prelude::Pose2D;
use horus_host::reference::evidence as std_version;

const SIDE: u32 = 64;

/// Beams from `first` on over `span` radians, all ranges 1.2 m.
fn check(first: f32, span: f32, beams: usize) {
    check_widths(first, span, beams, None);
}

fn check_widths(first: f32, span: f32, beams: usize, beam_half_width: Option<f32>) {
    let last = (beams - 1).max(1) as f32;
    let angles: Vec<f32> = (0..beams).map(|i| first + span * (i as f32 / last)).collect();
    let ranges = vec![1.2; beams];
    let scan = Flatscan {
        angles: &angles,
        ranges: &ranges,
        invalid_range_threshold: 0.0,
        out_of_range_threshold: 5.0,
        visibilities: None,
    };
    if scan.validate().is_err() {
        return; // beyond two turns
    }
    let lattice = Lattice::new(SIDE, SIDE, 0.05, [-0.5, -0.5], "robot").unwrap();
    let mut classes = vec![0; class_bytes(SIDE, SIDE)];
    let mut limits = vec![BeamLimits::EMPTY; beams];
    let model = SensorModel {
        beam_half_width,
        ..SensorModel::default()
    };
    let mut grid = SensorGrid::new_in(&mut classes, lattice, model).unwrap();
    grid.project(&scan, Pose2D::default(), &mut limits).unwrap();

    let std_model = std_version::SensorModel {
        m_free: std_version::Masses::VACUOUS,
        m_occ: std_version::Masses::VACUOUS,
        wall_thickness: model.wall_thickness,
        max_free_range: None,
        beam_half_width,
    };
    let std_lattice = std_version::Lattice {
        rows: SIDE,
        cols: SIDE,
        cell_size: 0.05,
        pose: [lattice.pose.x, lattice.pose.y, lattice.pose.theta],
    };
    let std_scan = std_version::Flatscan {
        angles: angles.clone(),
        ranges: ranges.clone(),
        invalid_range_threshold: 0.0,
        out_of_range_threshold: 5.0,
        visibilities: None,
    };
    let expected = std_version::classify(&std_scan, [0.0; 3], &std_lattice, &std_model);
    let cells = (0..SIDE).flat_map(|col| (0..SIDE).map(move |row| (row, col)));
    let mut seen = 0;
    for ((row, col), expected) in cells.zip(expected) {
        let same = match grid.class(row, col) {
            ScanClass::Vacuous => std_version::ScanClass::Vacuous,
            ScanClass::Free => std_version::ScanClass::Free,
            ScanClass::Occupied => std_version::ScanClass::Occupied,
        };
        seen += u32::from(same != std_version::ScanClass::Vacuous);
        assert_eq!(
            same, expected,
            "first {first}, span {span}, {beams} beams, {beam_half_width:?}: ({row}, {col})"
        );
    }
    assert!(seen > 0);
}

#[test]
fn full_turns_may_begin_anywhere() {
    for beams in [5, 9, 73, 361, 721] {
        for eighth in -8..=0i8 {
            check(f32::from(eighth) * PI / 4.0, TAU, beams);
            check(f32::from(eighth) * 0.77, TAU, beams);
        }
    }
}

#[test]
fn turns_that_overlap_or_stay_open() {
    for beams in [4, 73, 361] {
        for span in [TAU + 0.009, TAU + 2e-5, TAU - 1e-3, TAU - 0.02, TAU - 0.3, 5.0] {
            for first in [-TAU, -5.0, -PI, -3.0, -1.0, 0.0] {
                check(first, span, beams);
            }
        }
    }
}

/// Sonars: one cone, or a ring of few.
#[test]
fn few_wide_beams_may_point_anywhere() {
    for beams in 1..=4 {
        for half_width in [0.05, 0.3, 1.0, 2.0, PI] {
            for step in -13..=13i8 {
                let first = f32::from(step) * 0.48;
                for span in [0.1, 1.5, TAU * 0.75] {
                    check_widths(first, span, beams, Some(half_width));
                }
            }
        }
    }
}
