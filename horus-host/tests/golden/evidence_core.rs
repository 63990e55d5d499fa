//! The subject of the tests is `horus-core`, in all its cell types.

use horus_core::evidence::{
    self, BeamLimits, EvidenceF32, EvidenceU8, EvidenceU16, Flatscan, FusionOperator, FusionRule, Lattice,
    MassCell, ScanClass, SensorGrid, SensorModel, class_bytes,
};
use horus_core::prelude::Pose2D;

use crate::evidence::{GridCase, ScanCase};

pub type Masses = [f64; 3];

/// Whether the subject has fixed-point cells.
pub const HAS_INTEGERS: bool = true;

fn to(m: Masses) -> evidence::Masses {
    evidence::Masses::new(m[0] as f32, m[1] as f32, m[2] as f32).expect("masses")
}

fn from<M: MassCell>(cell: M) -> Masses {
    let m = cell.masses();
    [m.free(), m.occupied(), m.uncertain()].map(f64::from)
}

fn rule(name: &str) -> FusionRule {
    FusionRule {
        operator: name.parse().expect("an operator"),
        ignorance_floor: 0.0,
    }
}

/// The fusion in one cell type, unless it cannot take the rule, or one of the masses vanishes in it (which the limit
/// cases are about).
fn fuse_as<M: MassCell>(name: &str, one: Masses, two: Masses) -> Option<Option<Masses>> {
    let (mut state, sensor) = ([M::from_masses(to(one))], [M::from_masses(to(two))]);
    for (given, kept) in [(one, from(state[0])), (two, from(sensor[0]))] {
        if given.iter().zip(kept).any(|(g, k)| (*g > 0.0) != (k > 0.0)) {
            return None;
        }
    }
    let report = evidence::fuse(rule(name), &mut state, &sensor).ok()?;
    Some((report.undefined == 0).then(|| from(state[0])))
}

/// The fusion of two cells in every way of the subject, without an ignorance floor: name, tolerance, result.
pub fn fuse(name: &str, one: Masses, two: Masses) -> Vec<(&'static str, f64, Option<Masses>)> {
    // Rounding the inputs moves the result: little under PCR6, whose derivatives are at most 1, more where an
    // uncertain mass of a few steps divides.
    let divides = name.parse() != Ok(FusionOperator::Pcr6);
    let steps = |step: f64| if divides { 80.0 * step } else { 2.6 * step };
    let ways = [
        ("f32", 1e-6, fuse_as::<EvidenceF32>(name, one, two)),
        (
            "u16",
            steps(1.0 / 65_535.0),
            fuse_as::<EvidenceU16>(name, one, two),
        ),
        ("u8", steps(1.0 / 255.0), fuse_as::<EvidenceU8>(name, one, two)),
    ];
    ways.into_iter()
        .filter_map(|(way, tolerance, fused)| Some((way, tolerance, fused?)))
        .collect()
}

/// The fusion of two fixed-point cells; `None` if the type refuses the rule.
pub fn fuse_steps(q: u32, name: &str, a: [u32; 2], b: [u32; 2]) -> Option<[u32; 2]> {
    if q == 255 {
        let cell = |[f, o]: [u32; 2]| EvidenceU8::from_steps(f as u8, o as u8).expect("a cell");
        let mut state = [cell(a)];
        evidence::fuse(rule(name), &mut state, &[cell(b)]).ok()?;
        Some([state[0].free_steps(), state[0].occupied_steps()].map(u32::from))
    } else {
        let cell = |[f, o]: [u32; 2]| EvidenceU16::from_steps(f as u16, o as u16).expect("a cell");
        let mut state = [cell(a)];
        evidence::fuse(rule(name), &mut state, &[cell(b)]).ok()?;
        Some([state[0].free_steps(), state[0].occupied_steps()].map(u32::from))
    }
}

/// Masses as steps of a fixed-point cell.
pub fn steps(q: u32, masses: Masses) -> [u32; 2] {
    assert_eq!(q, 255);
    let cell = EvidenceU8::from_masses(to(masses));
    [cell.free_steps(), cell.occupied_steps()].map(u32::from)
}

fn lattice(rows: u32, cols: u32, cell_size: f32, [x, y, theta]: [f32; 3]) -> Lattice {
    Lattice {
        rows,
        cols,
        cell_size,
        pose: Pose2D::new(x, y, theta),
        ..Lattice::default()
    }
}

/// The class of every cell, x fastest: f, o or u.
pub fn classify(case: &ScanCase) -> Vec<(&'static str, Vec<char>)> {
    let scan = Flatscan {
        angles: &case.angles,
        ranges: &case.ranges,
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
    let lattice = lattice(case.rows, case.cols, case.cell_size, case.lattice_pose);
    let [x, y, yaw] = case.sensor;
    let sensor = Pose2D::new(x, y, yaw);
    let mut limits = vec![BeamLimits::EMPTY; case.angles.len()];

    let mut bytes = vec![0xff; class_bytes(case.rows, case.cols)];
    let mut grid = SensorGrid::new_in(&mut bytes, lattice, model).expect("a grid");
    grid.project(&scan, sensor, &mut limits).expect("a scan");
    let classes = (0..case.cols).flat_map(|col| (0..case.rows).map(move |row| (row, col)));
    let letter = |(row, col)| match grid.class(row, col) {
        ScanClass::Vacuous => 'u',
        ScanClass::Free => 'f',
        ScanClass::Occupied => 'o',
    };
    let classes = classes.map(letter).collect();

    let mut cells = vec![EvidenceU16::default(); lattice.cells()];
    evidence::scan_to_evidence(&scan, sensor, &lattice, &model, &mut limits, &mut cells).expect("a scan");
    let free = EvidenceU16::from_masses(model.m_free);
    let letter = |cell: &EvidenceU16| match cell {
        cell if cell.is_vacuous() => 'u',
        cell if *cell == free => 'f',
        _ => 'o',
    };
    vec![
        ("classes", classes),
        ("masses", cells.iter().map(letter).collect()),
    ]
}

fn resample_as<M: MassCell>(
    cells: &[Masses],
    src: GridCase,
    dst: GridCase,
    [x, y, theta]: [f64; 3],
) -> Vec<Masses> {
    let lattice_of = |grid: GridCase| lattice(grid.rows, grid.cols, grid.cell_size, grid.pose);
    let cells: Vec<M> = cells.iter().map(|m| M::from_masses(to(*m))).collect();
    let mut out = vec![M::from_masses(to([1.0, 0.0, 0.0])); lattice_of(dst).cells()];
    let pose = Pose2D::new(x as f32, y as f32, theta as f32);
    evidence::resample(&cells, &lattice_of(src), &mut out, &lattice_of(dst), pose).expect("resampled");
    out.into_iter().map(from).collect()
}

/// A grid resampled in every way of the subject: name, tolerance, result.
pub fn resample(
    cells: &[Masses],
    src: GridCase,
    dst: GridCase,
    src_from_dst: [f64; 3],
) -> Vec<(&'static str, f64, Vec<Masses>)> {
    // Two roundings to a step each for free and occupied, which add up in uncertain.
    let (q16, q8) = (2.1 / 65_535.0, 2.1 / 255.0);
    vec![
        (
            "f32",
            2e-6,
            resample_as::<EvidenceF32>(cells, src, dst, src_from_dst),
        ),
        (
            "u16",
            q16,
            resample_as::<EvidenceU16>(cells, src, dst, src_from_dst),
        ),
        ("u8", q8, resample_as::<EvidenceU8>(cells, src, dst, src_from_dst)),
    ]
}
