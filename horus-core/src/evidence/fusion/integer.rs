//! The kernels of the fixed-point cells.

use super::kernel::WHOLE;
use super::{FusionOperator, PreparedRule, Tally, share};
use crate::evidence::{MassCell, Masses};

/// A cell of two unsigned integers f + o <= Q, Q = 2^BITS - 1, BITS 8 or 16.
#[doc(hidden)]
pub trait IntegerCell: MassCell {
    const BITS: u32;
    /// The full scale Q.
    const Q: u32 = (1 << Self::BITS) - 1;

    fn parts(self) -> (u32, u32);

    /// A cell of two numbers that fit.
    fn of(free: u32, occupied: u32) -> Self;
}

/// Two cells and what follows of them; the products are at most Q^2 < 2^32.
struct Pair {
    one: [u32; 3],
    two: [u32; 3],
}

impl Pair {
    #[inline(always)]
    fn new<M: IntegerCell>(one: M, two: M) -> Self {
        let masses = |(f, o): (u32, u32)| [f, o, M::Q.wrapping_sub(f).wrapping_sub(o)];
        Self {
            one: masses(one.parts()),
            two: masses(two.parts()),
        }
    }

    /// Cf and Co: what both agree on or one leaves open.
    #[inline(always)]
    fn agreement<M: IntegerCell>(&self) -> [u32; 2] {
        let ([f1, o1, u1], [f2, o2, _]) = (self.one, self.two);
        let [first, second] = self.conflicts();
        // b1 b2 + b1 u2 = b1 (Q - what the second says against it): a shift, and the conflict's product.
        let of = |b1: u32, b2: u32, conflict: u32| {
            let not_against = b1.wrapping_mul(M::Q).wrapping_sub(conflict);
            not_against.wrapping_add(u1.wrapping_mul(b2))
        };
        [of(f1, f2, first), of(o1, o2, second)]
    }

    /// f1 o2 and f2 o1.
    #[inline(always)]
    fn conflicts(&self) -> [u32; 2] {
        let ([f1, o1, _], [f2, o2, _]) = (self.one, self.two);
        [f1.wrapping_mul(o2), f2.wrapping_mul(o1)]
    }
}

/// The part of a conflict unit in the whole, 1 / Q^2.
pub(crate) const fn conflict_unit<M: IntegerCell>() -> f32 {
    1.0 / (M::Q as f32 * M::Q as f32)
}

#[inline(always)]
pub(crate) fn fuse<M: IntegerCell>(rule: &PreparedRule, state: &mut [M], sensor: &[M]) -> Tally {
    match rule.operator {
        FusionOperator::Pcr6 => pcr6(state, sensor),
        FusionOperator::DempsterShafer => {
            let floor = Floor::new::<M>(rule);
            each(state, sensor, |pair, tally| {
                floor.apply::<M>(dempster::<M>(pair, tally))
            })
        }
        FusionOperator::JosangAverage => each(state, sensor, |pair, _| average::<M>(pair)),
        FusionOperator::JosangCumulative => {
            let floor = Floor::new::<M>(rule);
            each(state, sensor, |pair, _| floor.apply::<M>(cumulative::<M>(pair)))
        }
    }
}

/// Fuses by a rule of two cells, and counts conflicts.
#[inline(always)]
fn each<M: IntegerCell>(
    state: &mut [M],
    sensor: &[M],
    rule: impl Fn(&Pair, &mut Tally) -> [u32; 2],
) -> Tally {
    let mut tally = Tally::default();
    for (state, sensor) in state.iter_mut().zip(sensor) {
        let pair = Pair::new(*state, *sensor);
        let [first, second] = pair.conflicts();
        tally.count(first.wrapping_add(second));
        let [f, o] = rule(&pair, &mut tally);
        *state = M::of(f, o);
    }
    tally
}

/// Cells that are fused side by side where there are vector registers.
const LANES: usize = 32;

#[inline(always)]
fn pcr6<M: IntegerCell>(state: &mut [M], sensor: &[M]) -> Tally {
    let mut tally = Tally::default();
    let (mut state, mut sensor) = super::same_length(state, sensor);
    if super::HAS_VECTORS {
        let (states, state_rest) = state.as_chunks_mut::<LANES>();
        let (sensors, sensor_rest) = sensor.as_chunks::<LANES>();
        for (state, sensor) in states.iter_mut().zip(sensors) {
            pcr6_side_by_side(state, sensor, &mut tally);
        }
        (state, sensor) = (state_rest, sensor_rest);
    }
    for (state, sensor) in state.iter_mut().zip(sensor) {
        // One by one, a vacuous cell, which is neutral, takes no arithmetic.
        if sensor.is_vacuous() {
            continue;
        }
        let pair = Pair::new(*state, *sensor);
        let ([f1, o1, _], [f2, o2, _]) = (pair.one, pair.two);
        let shares = share::in_words(f1, o2).wrapping_add(share::in_words(f2, o1));
        let ([f, o], conflict) = redistributed::<M>(&pair, shares);
        tally.count(conflict);
        *state = M::of(f, o);
    }
    tally
}

/// Each step of the arithmetic for all cells, so that it is one of vectors.
#[inline(always)]
fn pcr6_side_by_side<M: IntegerCell>(state: &mut [M; LANES], sensor: &[M; LANES], tally: &mut Tally) {
    // A cell as one number is loaded as one, and taken apart by vectors.
    let whole = |cell: M| cell.parts().0 | cell.parts().1 << M::BITS;
    let (one, two) = (state.map(whole), sensor.map(whole));
    let (f1, o1) = (one.map(|cell| cell & M::Q), one.map(|cell| cell >> M::BITS));
    let (f2, o2) = (two.map(|cell| cell & M::Q), two.map(|cell| cell >> M::BITS));
    let shares = shares_side_by_side([&f1, &o1], [&f2, &o2]);
    let (mut conflicts, mut low, mut high) = (0u32, 0u32, 0u32);
    for i in 0..LANES {
        let pair = Pair::new(M::of(f1[i], o1[i]), M::of(f2[i], o2[i]));
        let ([f, o], conflict) = redistributed::<M>(&pair, shares[i]);
        state[i] = M::of(f, o);
        conflicts = conflicts.wrapping_add(u32::from(conflict != 0));
        low = low.wrapping_add(conflict & 0xffff);
        high = high.wrapping_add(conflict >> 16);
    }
    tally.conflicts = tally.conflicts.wrapping_add(conflicts);
    let mass = u64::from(low).wrapping_add(u64::from(high) << 16);
    tally.mass = tally.mass.wrapping_add(mass);
}

/// What of each conflict goes to free. A sensor's cell mostly says one thing only, and then one of its two
/// conflicts is 0: where that holds for all cells, one division each is enough.
#[inline(always)]
fn shares_side_by_side([f1, o1]: [&[u32; LANES]; 2], [f2, o2]: [&[u32; LANES]; 2]) -> [u32; LANES] {
    let (mut both, mut p, mut q) = ([0; LANES], [0; LANES], [0; LANES]);
    for i in 0..LANES {
        let mask = u32::from(o2[i] == 0).wrapping_sub(1);
        both[i] = f2[i] & mask;
        p[i] = f2[i] ^ ((f1[i] ^ f2[i]) & mask);
        q[i] = o2[i] | (o1[i] & !mask);
    }
    let mut shares = share::in_floats(&p, &q);
    if both.iter().fold(0, |any, f| any | f) != 0 {
        // The conflicts left out, of cells that say both.
        let others = share::in_floats(&both, o1);
        for (share, other) in shares.iter_mut().zip(others) {
            *share = share.wrapping_add(other);
        }
    }
    shares
}

/// Free and occupied of two cells fused, given what of their conflict goes to free, and the conflict.
#[inline(always)]
fn redistributed<M: IntegerCell>(pair: &Pair, shares: u32) -> ([u32; 2], u32) {
    let [f, o] = pair.agreement::<M>();
    let [first, second] = pair.conflicts();
    let conflict = first.wrapping_add(second);
    let f = f.wrapping_add(shares);
    let o = o.wrapping_add(conflict.wrapping_sub(shares));
    ([over_q::<M>(f), over_q::<M>(o)], conflict)
}

/// floor((2 n + Q) / (2 Q)), which for odd Q is floor((n + (Q - 1) / 2) / Q), for n <= Q^2.
///
/// n = a 2^BITS + b gives n / Q = a + (a + b) / Q, so that the quotient is what the carry makes of it.
#[inline(always)]
fn over_q<M: IntegerCell>(n: u32) -> u32 {
    let n = n.wrapping_add((M::Q - 1) / 2);
    n.wrapping_add(n >> M::BITS).wrapping_add(1) >> M::BITS
}

/// floor(n / d + 1/2) for 64 bits; d = 0 gives 0.
#[inline(always)]
fn nearest(n: u64, d: u64) -> u32 {
    n.wrapping_mul(2)
        .wrapping_add(d)
        .checked_div(d.wrapping_mul(2))
        .unwrap_or(0) as u32
}

/// Two rounded masses; where they exceed the whole, free gives way.
#[inline(always)]
fn clamped<M: IntegerCell>(f: u32, o: u32) -> [u32; 2] {
    let o = o.min(M::Q);
    [f.min(M::Q - o), o]
}

fn dempster<M: IntegerCell>(pair: &Pair, tally: &mut Tally) -> [u32; 2] {
    let whole = M::Q.wrapping_mul(M::Q);
    let [first, second] = pair.conflicts();
    let norm = whole.wrapping_sub(first).wrapping_sub(second);
    if norm == 0 {
        tally.undefined = tally.undefined.wrapping_add(1);
        return [0, 0];
    }
    let scaled = pair.agreement::<M>().map(|c| {
        let n = u64::from(c).wrapping_mul(u64::from(M::Q));
        nearest(n, u64::from(norm))
    });
    clamped::<M>(scaled[0], scaled[1])
}

/// b1 u2 + b2 u1 for free and occupied, each at most Q^2.
#[inline(always)]
fn crossed(pair: &Pair) -> [u32; 2] {
    let ([f1, o1, u1], [f2, o2, u2]) = (pair.one, pair.two);
    let of = |b1: u32, b2: u32| b1.wrapping_mul(u2).wrapping_add(b2.wrapping_mul(u1));
    [of(f1, f2), of(o1, o2)]
}

/// The mean of two cells without uncertainty, halves up.
#[inline(always)]
fn mean<M: IntegerCell>(pair: &Pair) -> [u32; 2] {
    let ([f1, o1, _], [f2, o2, _]) = (pair.one, pair.two);
    let half = |sum: u32| sum.wrapping_add(1) >> 1;
    clamped::<M>(half(f1.wrapping_add(f2)), half(o1.wrapping_add(o2)))
}

fn average<M: IntegerCell>(pair: &Pair) -> [u32; 2] {
    let sum = pair.one[2].wrapping_add(pair.two[2]);
    if sum == 0 {
        return mean::<M>(pair);
    }
    // Rounded to the nearest; the sum of numerator and half the divisor stays below 2^32.
    let [f, o] = crossed(pair).map(|n| n.wrapping_add(sum >> 1).checked_div(sum).unwrap_or(0));
    clamped::<M>(f, o)
}

fn cumulative<M: IntegerCell>(pair: &Pair) -> [u32; 2] {
    let (u1, u2) = (u64::from(pair.one[2]), u64::from(pair.two[2]));
    let q = u64::from(M::Q);
    // Q (u1 + u2) - u1 u2, in units of 1 / Q^2
    let norm = q
        .wrapping_mul(u1.wrapping_add(u2))
        .wrapping_sub(u1.wrapping_mul(u2));
    if norm == 0 {
        return mean::<M>(pair);
    }
    let [f, o] = crossed(pair).map(|n| nearest(u64::from(n).wrapping_mul(q), norm));
    clamped::<M>(f, o)
}

/// The ignorance floor in steps; 0: none.
struct Floor(u32);

impl Floor {
    fn new<M: IntegerCell>(rule: &PreparedRule) -> Self {
        let steps = f64::from(rule.floor) * f64::from(M::Q);
        let whole = steps as u32;
        Self(if f64::from(whole) < steps {
            whole.wrapping_add(1)
        } else {
            whole
        })
    }

    fn apply<M: IntegerCell>(&self, [f, o]: [u32; 2]) -> [u32; 2] {
        let known = f.wrapping_add(o);
        let most = M::Q.wrapping_sub(self.0);
        if known <= most {
            return [f, o];
        }
        let f = f.wrapping_mul(most).checked_div(known).unwrap_or(0);
        [f, most.wrapping_sub(f)]
    }
}

pub(crate) fn interpolate<M: IntegerCell>(corners: [M; 4], weights: [u32; 4]) -> M {
    let (mut f, mut o) = (u64::from(WHOLE / 2), u64::from(WHOLE / 2));
    for (corner, weight) in corners.into_iter().zip(weights) {
        let (cf, co) = corner.parts();
        f = f.wrapping_add(u64::from(cf).wrapping_mul(u64::from(weight)));
        o = o.wrapping_add(u64::from(co).wrapping_mul(u64::from(weight)));
    }
    let [f, o] = clamped::<M>((f >> 31) as u32, (o >> 31) as u32);
    M::of(f, o)
}

/// A sensor's two masses, (f, o) each with 16 more bits than a step.
#[derive(Clone, Copy, Debug)]
pub struct Blend<M> {
    free: [u32; 2],
    occupied: [u32; 2],
    whole: [M; 2],
}

impl<M: IntegerCell> Blend<M> {
    pub(crate) fn new(free: Masses, occupied: Masses) -> Self {
        let scale = f64::from(M::Q) * 65_536.0;
        let fine = |mass: f32| (f64::from(mass) * scale + 0.5) as u32;
        let of = |masses: Masses| [fine(masses.free()), fine(masses.occupied())];
        Self {
            free: of(free),
            occupied: of(occupied),
            whole: [M::from_masses(free), M::from_masses(occupied)],
        }
    }

    #[inline]
    pub(crate) fn mix(&self, free: u32, occupied: u32) -> M {
        if free == WHOLE {
            return self.whole[0];
        }
        if occupied == WHOLE {
            return self.whole[1];
        }
        let of = |axis: usize| {
            let sum = u64::from(free)
                .wrapping_mul(u64::from(self.free[axis]))
                .wrapping_add(u64::from(occupied).wrapping_mul(u64::from(self.occupied[axis])));
            // 31 bits of weight and 16 of mass; the high word has 15 of them.
            ((sum >> 32) as u32).wrapping_add(1 << 14) >> 15
        };
        let [f, o] = clamped::<M>(of(0), of(1));
        M::of(f, o)
    }
}
