//! The subject of the tests is the std version.

use horus_host::reference::evidence as std_version;
use std_version::{Flatscan, FusionOperator, Lattice, ScanClass, SensorModel};

use crate::evidence::{GridCase, ScanCase};

pub type Masses = [f64; 3];

/// Whether the subject has fixed-point cells.
pub const HAS_INTEGERS: bool = false;

fn to(m: Masses) -> std_version::Masses {
    std_version::Masses::new(m[0], m[1], m[2])
}

fn from(m: &std_version::Masses) -> Masses {
    [m.free, m.occupied, m.uncertain]
}

/// The fusion of two cells in every way of the subject, without an ignorance floor: name, tolerance, result.
pub fn fuse(rule: &str, one: Masses, two: Masses) -> Vec<(&'static str, f64, Option<Masses>)> {
    let operator = FusionOperator::from_name(rule).expect("an operator");
    let fused = std_version::fuse(operator, 0.0, to(one), to(two));
    vec![("std version", 1e-12, fused.as_ref().map(from))]
}

/// The fusion of two fixed-point cells; `None` if the type refuses the rule.
pub fn fuse_steps(_: u32, _: &str, _: [u32; 2], _: [u32; 2]) -> Option<[u32; 2]> {
    None
}

/// Masses as steps of a fixed-point cell.
pub fn steps(_: u32, _: Masses) -> [u32; 2] {
    [0, 0]
}

fn lattice(case: GridCase) -> Lattice {
    Lattice {
        rows: case.rows,
        cols: case.cols,
        cell_size: case.cell_size,
        pose: case.pose,
    }
}

/// The class of every cell, x fastest: f, o or u.
pub fn classify(case: &ScanCase) -> Vec<(&'static str, Vec<char>)> {
    let scan = Flatscan {
        angles: case.angles.clone(),
        ranges: case.ranges.clone(),
        invalid_range_threshold: case.invalid_range,
        out_of_range_threshold: case.out_of_range,
        visibilities: None,
    };
    let model = SensorModel {
        m_free: to(case.m_free),
        m_occ: to(case.m_occ),
        wall_thickness: case.wall_thickness,
        max_free_range: case.max_free_range,
        beam_half_width: None,
    };
    let grid = Lattice {
        rows: case.rows,
        cols: case.cols,
        cell_size: case.cell_size,
        pose: case.lattice_pose,
    };
    let classes = std_version::classify(&scan, case.sensor, &grid, &model);
    let letter = |class: &ScanClass| match class {
        ScanClass::Vacuous => 'u',
        ScanClass::Free => 'f',
        ScanClass::Occupied => 'o',
    };
    vec![("std version", classes.iter().map(letter).collect())]
}

/// A grid resampled in every way of the subject: name, tolerance, result.
pub fn resample(
    cells: &[Masses],
    src: GridCase,
    dst: GridCase,
    src_from_dst: [f64; 3],
) -> Vec<(&'static str, f64, Vec<Masses>)> {
    let cells: Vec<_> = cells.iter().copied().map(to).collect();
    let got = std_version::resample(&cells, &lattice(src), &lattice(dst), src_from_dst);
    // The poses of lattices are f32.
    vec![("std version", 1e-6, got.iter().map(from).collect())]
}
