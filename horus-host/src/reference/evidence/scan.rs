//! Which beam covers a cell, and what it says: f32, every operation in this order, every beam asked.

use std::f32::consts::{PI, TAU};

use super::{Lattice, Masses};

/// One sweep of a range sensor; see the core's type of that name.
#[derive(Debug, Clone, PartialEq)]
pub struct Flatscan {
    /// Directions of the beams, ascending.
    pub angles: Vec<f32>,
    /// One range per beam.
    pub ranges: Vec<f32>,
    /// Ranges up to this say nothing.
    pub invalid_range_threshold: f32,
    /// Ranges from this on are no hit.
    pub out_of_range_threshold: f32,
    /// How far each beam could see.
    pub visibilities: Option<Vec<f32>>,
}

/// What beams say about cells; see the core's type of that name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SensorModel {
    /// Masses before the hit.
    pub m_free: Masses,
    /// Masses at the hit.
    pub m_occ: Masses,
    /// Depth of an obstacle, metres.
    pub wall_thickness: f32,
    /// How far a beam without a hit frees cells, metres; `None`: `out_of_range_threshold`.
    pub max_free_range: Option<f32>,
    /// Half the angle of each beam instead of half the gaps.
    pub beam_half_width: Option<f32>,
}

/// What a scan says about a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ScanClass {
    /// Nothing.
    Vacuous,
    /// Before the hit.
    Free,
    /// At the hit.
    Occupied,
}

impl ScanClass {
    /// Its masses.
    pub fn masses(self, model: &SensorModel) -> Masses {
        match self {
            Self::Vacuous => Masses::VACUOUS,
            Self::Free => model.m_free,
            Self::Occupied => model.m_occ,
        }
    }
}

/// The class of every cell, in the order of storage; `sensor` is x, y (metres) and heading (radians) in the
/// lattice's frame.
pub fn classify(scan: &Flatscan, sensor: [f32; 3], lattice: &Lattice, model: &SensorModel) -> Vec<ScanClass> {
    let [sx, sy, yaw] = sensor;
    let (c, s) = (libm::cosf(yaw), libm::sinf(yaw));
    let class = |(row, col)| {
        let [cx, cy] = lattice.center(row, col);
        let x = c * (cx - sx) + s * (cy - sy);
        let y = c * (cy - sy) - s * (cx - sx);
        let d2 = x * x + y * y;
        match covering_beam(scan, model, libm::atan2f(y, x)) {
            Some(beam) => class_along(scan, model, beam, d2),
            None => ScanClass::Vacuous,
        }
    };
    lattice.cells().map(class).collect()
}

/// The same as masses.
pub fn scan_to_evidence(
    scan: &Flatscan,
    sensor: [f32; 3],
    lattice: &Lattice,
    model: &SensorModel,
) -> Vec<Masses> {
    let classes = classify(scan, sensor, lattice, model);
    classes.into_iter().map(|class| class.masses(model)).collect()
}

/// The nearest beam, if it reaches as far as direction `a`.
fn covering_beam(scan: &Flatscan, model: &SensorModel, a: f32) -> Option<usize> {
    let angle = &scan.angles;
    let n = angle.len();
    let difference = |i: usize| {
        let d = a - angle[i];
        if d > PI {
            d - TAU
        } else if d < -PI {
            d + TAU
        } else {
            d
        }
    };
    // Of equal minima, `min_by` keeps the first.
    let nearest = (0..n).min_by(|&i, &k| difference(i).abs().total_cmp(&difference(k).abs()))?;
    let d = difference(nearest);
    if let Some(half) = model.beam_half_width {
        return (d.abs() <= half).then_some(nearest);
    }
    let gaps: Vec<f32> = (1..n).map(|i| angle[i] - angle[i - 1]).collect();
    let closing = (angle[0] + TAU) - angle[n - 1];
    let is_circle = closing <= 1.5 * gaps.iter().copied().fold(0.0, f32::max);
    let (before, after) = match nearest {
        0 if is_circle => (closing, gaps[0]),
        0 => (gaps[0], gaps[0]),
        i if i < n - 1 => (gaps[i - 1], gaps[i]),
        i if is_circle => (gaps[i - 1], closing),
        i => (gaps[i - 1], gaps[i - 1]),
    };
    let gap = if d >= 0.0 { after } else { before };
    (d.abs() <= 0.5 * gap).then_some(nearest)
}

fn class_along(scan: &Flatscan, model: &SensorModel, beam: usize, d2: f32) -> ScanClass {
    let z = scan.ranges[beam];
    if z.is_nan() || z == f32::NEG_INFINITY || z <= scan.invalid_range_threshold {
        return ScanClass::Vacuous;
    }
    if let Some(visibilities) = &scan.visibilities {
        let v = visibilities[beam];
        if v <= 0.0 || d2 >= v * v {
            return ScanClass::Vacuous;
        }
    }
    if z == f32::INFINITY || z >= scan.out_of_range_threshold {
        let reach = model.max_free_range.unwrap_or(scan.out_of_range_threshold);
        return if d2 < reach * reach {
            ScanClass::Free
        } else {
            ScanClass::Vacuous
        };
    }
    let back = z + model.wall_thickness;
    if d2 < z * z {
        ScanClass::Free
    } else if d2 < back * back {
        ScanClass::Occupied
    } else {
        ScanClass::Vacuous
    }
}
