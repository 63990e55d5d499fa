//! The four fusion rules, as their sources write them.

use super::Masses;

/// A fusion rule by Isaac's names.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FusionOperator {
    /// `pcr6`
    Pcr6,
    /// `dempster_shafer`
    DempsterShafer,
    /// `josang_average`
    JosangAverage,
    /// `josang_cumulative`
    JosangCumulative,
}

impl FusionOperator {
    /// The operator of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        match name {
            "pcr6" => Some(Self::Pcr6),
            "dempster_shafer" => Some(Self::DempsterShafer),
            "josang_average" => Some(Self::JosangAverage),
            "josang_cumulative" => Some(Self::JosangCumulative),
            _ => None,
        }
    }
}

/// Fuses two cells; `floor` is the least uncertain mass under Dempster's and Josang's cumulative rule (0: none).
///
/// `None`: Dempster's rule is undefined, because the conflict is total.
pub fn fuse(operator: FusionOperator, floor: f64, one: Masses, two: Masses) -> Option<Masses> {
    Some(match operator {
        FusionOperator::Pcr6 => pcr6(one, two),
        FusionOperator::DempsterShafer => floored(dempster_shafer(one, two)?, floor),
        FusionOperator::JosangAverage => josang_average(one, two),
        FusionOperator::JosangCumulative => floored(josang_cumulative(one, two), floor),
    })
}

/// What both agree on, or one leaves open.
pub fn conjunctive(one: Masses, two: Masses) -> Masses {
    Masses::new(
        one.free * two.free + one.free * two.uncertain + one.uncertain * two.free,
        one.occupied * two.occupied + one.occupied * two.uncertain + one.uncertain * two.occupied,
        one.uncertain * two.uncertain,
    )
}

fn pcr6(one: Masses, two: Masses) -> Masses {
    let ratio = |n: f64, d: f64| if d == 0.0 { 0.0 } else { n / d };
    let (f1, o1, f2, o2) = (one.free, one.occupied, two.free, two.occupied);
    let c = conjunctive(one, two);
    Masses::new(
        c.free + ratio(f1 * f1 * o2, f1 + o2) + ratio(f2 * f2 * o1, f2 + o1),
        c.occupied + ratio(o1 * o1 * f2, o1 + f2) + ratio(o2 * o2 * f1, o2 + f1),
        c.uncertain,
    )
}

fn dempster_shafer(one: Masses, two: Masses) -> Option<Masses> {
    let c = conjunctive(one, two);
    let agreement = c.free + c.occupied + c.uncertain; // 1 - K
    (agreement > 0.0).then(|| {
        Masses::new(
            c.free / agreement,
            c.occupied / agreement,
            c.uncertain / agreement,
        )
    })
}

fn josang_average(one: Masses, two: Masses) -> Masses {
    let (u1, u2) = (one.uncertain, two.uncertain);
    if u1 + u2 == 0.0 {
        return mean(one, two);
    }
    let belief = |b1: f64, b2: f64| (b1 * u2 + b2 * u1) / (u1 + u2);
    Masses::new(
        belief(one.free, two.free),
        belief(one.occupied, two.occupied),
        2.0 * u1 * u2 / (u1 + u2),
    )
}

fn josang_cumulative(one: Masses, two: Masses) -> Masses {
    let (u1, u2) = (one.uncertain, two.uncertain);
    if u1 == 0.0 && u2 == 0.0 {
        return mean(one, two);
    }
    let norm = u1 + u2 - u1 * u2;
    let belief = |b1: f64, b2: f64| (b1 * u2 + b2 * u1) / norm;
    Masses::new(
        belief(one.free, two.free),
        belief(one.occupied, two.occupied),
        u1 * u2 / norm,
    )
}

fn mean(one: Masses, two: Masses) -> Masses {
    Masses::new(
        (one.free + two.free) / 2.0,
        (one.occupied + two.occupied) / 2.0,
        (one.uncertain + two.uncertain) / 2.0,
    )
}

fn floored(m: Masses, floor: f64) -> Masses {
    if m.uncertain >= floor {
        return m;
    }
    let scale = (1.0 - floor) / (m.free + m.occupied);
    Masses::new(m.free * scale, m.occupied * scale, floor)
}
