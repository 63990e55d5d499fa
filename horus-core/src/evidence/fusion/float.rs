//! The kernels of the f32 cell. No branches: a compiler makes vectors of them.

use super::kernel::WHOLE;
use super::{FusionOperator, PreparedRule, Tally};
use crate::evidence::{EvidenceF32, Masses};

/// Conflict mass is summed as integers of this unit, so that the order of a sum cannot matter.
pub(crate) const CONFLICT_UNIT: f32 = 1.0 / 8_388_608.0;

#[inline(always)]
pub(crate) fn fuse(rule: &PreparedRule, state: &mut [EvidenceF32], sensor: &[EvidenceF32]) -> Tally {
    let floor = rule.floor;
    match rule.operator {
        FusionOperator::Pcr6 => each(state, sensor, |pair, _| pair.pcr6()),
        FusionOperator::DempsterShafer => each(state, sensor, |pair, undefined| {
            floored(pair.unless_vacuous(pair.dempster(undefined)), floor)
        }),
        FusionOperator::JosangAverage => each(state, sensor, |pair, _| normalised(pair.average())),
        FusionOperator::JosangCumulative => each(state, sensor, |pair, _| {
            floored(pair.unless_vacuous(pair.cumulative()), floor)
        }),
    }
}

/// Cells whose conflicts are counted in 32 bits.
const CHUNK: usize = 256;

#[inline(always)]
fn each(
    state: &mut [EvidenceF32],
    sensor: &[EvidenceF32],
    rule: impl Fn(&Pair, &mut u32) -> EvidenceF32,
) -> Tally {
    let mut tally = Tally::default();
    for (state, sensor) in state.chunks_mut(CHUNK).zip(sensor.chunks(CHUNK)) {
        // One loop that reads, computes and writes: a compiler makes vectors of it.
        let (mut conflicts, mut units, mut undefined) = (0u32, 0u32, 0u32);
        for (state, sensor) in state.iter_mut().zip(sensor) {
            let pair = Pair::new(*state, *sensor);
            let conflict = pair.conflict();
            conflicts = conflicts.wrapping_add(u32::from(conflict > 0.0));
            // 1 + K as bits is 1 as bits plus K in units of 2^-23.
            units = units.wrapping_add((1.0 + conflict).to_bits().wrapping_sub(1.0f32.to_bits()));
            let mut is_undefined = 0;
            *state = rule(&pair, &mut is_undefined);
            undefined = undefined.wrapping_add(is_undefined);
        }
        tally.conflicts = tally.conflicts.wrapping_add(conflicts);
        // At most 256 * 2^23.
        tally.mass = tally.mass.wrapping_add(u64::from(units));
        tally.undefined = tally.undefined.wrapping_add(undefined);
    }
    tally
}

struct Pair {
    one: [f32; 3],
    two: [f32; 3],
}

impl Pair {
    #[inline(always)]
    fn new(one: EvidenceF32, two: EvidenceF32) -> Self {
        let masses = |(f, o): (f32, f32)| [f, o, not_negative((1.0 - f) - o)];
        Self {
            one: masses(one.parts()),
            two: masses(two.parts()),
        }
    }

    /// Fused masses normalised; or, if one side is vacuous, to which the rule is neutral, the other
    /// side as it was, to the bit.
    #[inline(always)]
    fn unless_vacuous(&self, fused: [f32; 3]) -> EvidenceF32 {
        let ([f1, o1, _], [f2, o2, _]) = (self.one, self.two);
        let fused = normalised(fused);
        if f2 + o2 == 0.0 {
            EvidenceF32::of(f1, o1)
        } else if f1 + o1 == 0.0 {
            EvidenceF32::of(f2, o2)
        } else {
            fused
        }
    }

    #[inline(always)]
    fn conflict(&self) -> f32 {
        let ([f1, o1, _], [f2, o2, _]) = (self.one, self.two);
        f1 * o2 + o1 * f2
    }

    #[inline(always)]
    fn agreement(&self) -> [f32; 3] {
        let ([f1, o1, u1], [f2, o2, u2]) = (self.one, self.two);
        let of = |b1: f32, b2: f32| b1 * b2 + (b1 * u2 + u1 * b2);
        [of(f1, f2), of(o1, o2), u1 * u2]
    }

    #[inline(always)]
    fn pcr6(&self) -> EvidenceF32 {
        let ([f1, o1, _], [f2, o2, _]) = (self.one, self.two);
        let [f, o, _] = self.agreement();
        let (first, second) = (part(f1, o2), part(f2, o1));
        // The sum is 1 but for rounding, and the uncertain mass takes that: no more is needed than
        // that it stays a mass. A vacuous side leaves the other as it was, to the bit.
        bounded(f + (f1 * first + f2 * second), o + (o2 * first + o1 * second))
    }

    #[inline(always)]
    fn dempster(&self, undefined: &mut u32) -> [f32; 3] {
        let agreement = self.agreement();
        // The norm 1 - K as the sum of what remains: no cancellation near K = 1.
        let norm = (agreement[0] + agreement[1]) + agreement[2];
        // Below that nothing can be divided by it.
        let is_total = norm < f32::MIN_POSITIVE;
        *undefined = u32::from(is_total);
        if is_total { [0.0, 0.0, 1.0] } else { agreement }
    }

    #[inline(always)]
    fn crossed(&self) -> [f32; 2] {
        let ([f1, o1, u1], [f2, o2, u2]) = (self.one, self.two);
        [f1 * u2 + f2 * u1, o1 * u2 + o2 * u1]
    }

    #[inline(always)]
    fn mean(&self) -> [f32; 3] {
        let ([f1, o1, _], [f2, o2, _]) = (self.one, self.two);
        [0.5 * (f1 + f2), 0.5 * (o1 + o2), 0.0]
    }

    #[inline(always)]
    fn average(&self) -> [f32; 3] {
        let (u1, u2) = (self.one[2], self.two[2]);
        let [f, o] = self.crossed();
        if u1 + u2 > 0.0 {
            [f, o, 2.0 * (u1 * u2)]
        } else {
            self.mean()
        }
    }

    #[inline(always)]
    fn cumulative(&self) -> [f32; 3] {
        let (u1, u2) = (self.one[2], self.two[2]);
        let [f, o] = self.crossed();
        if u1 + u2 > 0.0 {
            [f, o, u1 * u2]
        } else {
            self.mean()
        }
    }
}

#[inline(always)]
fn not_negative(x: f32) -> f32 {
    if x > 0.0 { x } else { 0.0 }
}

/// p q / (p + q), 0 if both are 0: without a branch, for what is divided is 0 where the sum is too
/// small.
#[inline(always)]
fn part(p: f32, q: f32) -> f32 {
    let sum = p + q;
    p * q
        / if sum > f32::MIN_POSITIVE {
            sum
        } else {
            f32::MIN_POSITIVE
        }
}

/// Two masses; where rounding made them exceed the whole, free gives way first.
#[inline(always)]
pub(crate) fn bounded(f: f32, o: f32) -> EvidenceF32 {
    let o = if o < 1.0 { o } else { 1.0 };
    let most = 1.0 - o;
    EvidenceF32::of(if f < most { f } else { most }, o)
}

/// Three masses scaled to sum to 1; the third is implied. Dividing by their sum is also what
/// Dempster's norm and the denominators of Josang's rules do.
#[inline(always)]
fn normalised([f, o, u]: [f32; 3]) -> EvidenceF32 {
    let scale = 1.0 / ((f + o) + u);
    EvidenceF32::of(f * scale, o * scale)
}

/// Raises the uncertain mass to the floor.
#[inline(always)]
fn floored(cell: EvidenceF32, floor: f32) -> EvidenceF32 {
    let (f, o) = cell.parts();
    let (known, most) = (f + o, 1.0 - floor);
    if known > most {
        let scale = most / known;
        EvidenceF32::of(f * scale, o * scale)
    } else {
        cell
    }
}

/// A weight as a number, 0 to 1.
fn number(weight: u32) -> f32 {
    weight as f32 * (1.0 / WHOLE as f32)
}

pub(crate) fn interpolate(corners: [EvidenceF32; 4], weights: [u32; 4]) -> EvidenceF32 {
    let (mut f, mut o) = (0.0, 0.0);
    for (corner, weight) in corners.into_iter().zip(weights) {
        let (cf, co) = corner.parts();
        f += cf * number(weight);
        o += co * number(weight);
    }
    bounded(f, o)
}

pub(crate) fn mix([free, occupied]: &[Masses; 2], weight_free: u32, weight_occupied: u32) -> EvidenceF32 {
    let (wf, wo) = (number(weight_free), number(weight_occupied));
    bounded(
        wf * free.free() + wo * occupied.free(),
        wf * free.occupied() + wo * occupied.occupied(),
    )
}
