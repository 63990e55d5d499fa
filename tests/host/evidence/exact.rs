//! PCR6 on fixed-point cells against exact fractions.

use horus_core::evidence::{EvidenceU8, EvidenceU16, FusionRule, fuse};
use proptest::prelude::*;

/// The exact result of PCR6 for masses in steps of 1 / q, as numerators over q^2 * s1 * s2 (free, occupied), with s1 s2.
fn exact(q: i64, [f1, o1]: [i64; 2], [f2, o2]: [i64; 2]) -> ([i64; 2], i64) {
    let (u1, u2) = (q - f1 - o1, q - f2 - o2);
    let (s1, s2) = ((f1 + o2).max(1), (f2 + o1).max(1));
    let agreement = |b1: i64, b2: i64| b1 * b2 + b1 * u2 + u1 * b2;
    let free = agreement(f1, f2) * s1 * s2 + f1 * f1 * o2 * s2 + f2 * f2 * o1 * s1;
    let occupied = agreement(o1, o2) * s1 * s2 + o2 * o2 * f1 * s2 + o1 * o1 * f2 * s1;
    ([free, occupied], s1 * s2)
}

/// All valid states of one byte each: 32 896.
fn states() -> Vec<EvidenceU8> {
    let pairs = (0..=255u8).flat_map(|f| (0..=255 - f).map(move |o| (f, o)));
    pairs
        .map(|(f, o)| EvidenceU8::from_steps(f, o).unwrap())
        .collect()
}

#[test]
fn pcr6_on_bytes_is_right_for_every_state() {
    let all = states();
    assert_eq!(all.len(), 32_896);
    let parts = |cell: &EvidenceU8| [cell.free_steps(), cell.occupied_steps()].map(i64::from);
    // A thousand of them, spread, the corners among them.
    let sample = all.iter().step_by(33).copied().chain([all[255], all[32_895]]);
    let mut compared = 0u64;
    for sensor in sample {
        let mut fused = all.clone();
        fuse(FusionRule::default(), &mut fused, &vec![sensor; all.len()]).unwrap();
        for (before, after) in all.iter().zip(&fused) {
            let (exact, scale) = exact(255, parts(before), parts(&sensor));
            let [f, o] = parts(after);
            assert_eq!(f + o + i64::from(after.uncertain_steps()), 255);
            // In steps: |f - exact / (255 scale)| <= 0.506.
            let unit = 255 * scale;
            let u = 255 * unit - exact[0] - exact[1];
            let off = |got: i64, exact: i64| (got * unit - exact).abs();
            assert!(
                1000 * off(f, exact[0]) <= 506 * unit,
                "{before:?} + {sensor:?} = {after:?}"
            );
            assert!(
                1000 * off(o, exact[1]) <= 506 * unit,
                "{before:?} + {sensor:?} = {after:?}"
            );
            assert!(off(255 - f - o, u) <= unit, "{before:?} + {sensor:?} = {after:?}");
            compared += 1;
        }
    }
    assert!(compared > 32_000_000, "{compared}");
}

fn cell() -> impl Strategy<Value = EvidenceU16> {
    let parts = (0..=65_535u16).prop_flat_map(|f| (Just(f), 0..=65_535 - f));
    prop_oneof![
        4 => parts,
        1 => Just((0, 0)),
        1 => (0..=65_535u16).prop_map(|f| (f, 65_535 - f)),
        1 => (0..4u16, 0..4u16),
        1 => Just((65_535, 0)),
    ]
    .prop_map(|(f, o)| EvidenceU16::from_steps(f, o).unwrap())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4096))]

    #[test]
    fn pcr6_on_words_is_within_its_bound(one in cell(), two in cell()) {
        let parts = |cell: EvidenceU16| [cell.free_steps(), cell.occupied_steps()].map(i128::from);
        let mut fused = [one];
        fuse(FusionRule::default(), &mut fused, &[two]).unwrap();
        let ([f1, o1], [f2, o2], q) = (parts(one), parts(two), 65_535i128);
        let (s1, s2) = ((f1 + o2).max(1), (f2 + o1).max(1));
        let u1 = q - f1 - o1;
        let u2 = q - f2 - o2;
        let free = (f1 * f2 + f1 * u2 + u1 * f2) * s1 * s2 + f1 * f1 * o2 * s2 + f2 * f2 * o1 * s1;
        let unit = q * s1 * s2;
        let off = (parts(fused[0])[0] * unit - free).abs();
        prop_assert!(1000 * off <= 506 * unit, "{one:?} + {two:?} = {:?}", fused[0]);
        // u = u1 u2 within a step
        let u = i128::from(fused[0].uncertain_steps());
        prop_assert!((u * q - u1 * u2).abs() <= q);
    }
}
