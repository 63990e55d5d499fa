//! Properties of the fusion rules, in every cell type that takes them.

use horus_core::Error;
use horus_core::evidence::{
    EvidenceF32, EvidenceU8, EvidenceU16, FusionOperator, FusionRule, MassCell, Masses, fuse,
};
use proptest::prelude::*;

fn rule(operator: FusionOperator, ignorance_floor: f32) -> FusionRule {
    FusionRule {
        operator,
        ignorance_floor,
    }
}

fn fused<M: MassCell>(rule: FusionRule, one: M, two: M) -> Option<M> {
    let mut state = [one];
    fuse(rule, &mut state, &[two]).ok()?;
    Some(state[0])
}

fn masses() -> impl Strategy<Value = Masses> {
    let parts = (0.0..=1.0f32, 0.0..=1.0f32, 0..6u8);
    parts.prop_map(|(known, share, kind)| match kind {
        0 => Masses::VACUOUS,
        1 => Masses::known(known, 0.0).unwrap(),
        2 => Masses::known(share, 1.0 - share).unwrap(),
        _ => Masses::known(known * share, known * (1.0 - share)).unwrap(),
    })
}

/// What must hold of any cell type; `step` is its resolution.
fn holds<M: MassCell>(one: Masses, two: Masses, step: f32) {
    let (a, b) = (M::from_masses(one), M::from_masses(two));
    let vacuous = M::VACUOUS;
    for operator in FusionOperator::ALL {
        for floor in [0.0, 0.02] {
            let rule = rule(operator, floor);
            let Some(ab) = fused(rule, a, b) else {
                assert_eq!(M::supports(rule), Err(Error::UnsupportedFusion));
                continue;
            };
            assert_eq!(
                Some(ab),
                fused(rule, b, a),
                "{operator}: commutative: {a:?} {b:?}"
            );
            let m = ab.masses();
            let parts = [m.free(), m.occupied(), m.uncertain()];
            assert!(
                parts.iter().all(|p| (0.0..=1.0 + 2.0 * f32::EPSILON).contains(p)),
                "{ab:?}"
            );
            assert!(
                (parts.iter().sum::<f32>() - 1.0).abs() <= 2.0 * f32::EPSILON,
                "{ab:?}"
            );
            let floored = matches!(
                operator,
                FusionOperator::DempsterShafer | FusionOperator::JosangCumulative
            );
            if floored {
                assert!(m.uncertain() >= floor - 2.0 * f32::EPSILON, "{operator}: {ab:?}");
            }
            if operator != FusionOperator::JosangAverage
                && (!floored || a.masses().uncertain() >= floor + 2.0 * f32::EPSILON)
            {
                assert_eq!(fused(rule, a, vacuous), Some(a), "{operator}: vacuous is neutral");
            }
        }
    }
    let average = rule(FusionOperator::JosangAverage, 0.0);
    let again = fused(average, a, a).unwrap();
    assert!(
        far(a, again) <= 2.0 * step,
        "average is idempotent: {a:?} {again:?}"
    );

    // Without a conflict, Dempster's rule is PCR6. So small a mass is none in 16 bits.
    let (pa, pb) = (a.masses(), b.masses());
    let conflict = pa.free() * pb.occupied() + pa.occupied() * pb.free();
    if let Some(dempster) = fused(rule(FusionOperator::DempsterShafer, 0.0), a, b)
        && conflict == 0.0
    {
        let pcr6 = fused(FusionRule::default(), a, b).unwrap();
        assert!(
            far(pcr6, dempster) <= 2.0 * step,
            "{a:?} {b:?}: {pcr6:?} {dempster:?}"
        );
    }
}

fn far<M: MassCell>(one: M, two: M) -> f32 {
    let (one, two) = (one.masses(), two.masses());
    (one.free() - two.free())
        .abs()
        .max((one.occupied() - two.occupied()).abs())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4096))]

    #[test]
    fn every_rule_keeps_its_properties(one in masses(), two in masses()) {
        holds::<EvidenceU16>(one, two, 1.0 / 65_535.0);
        holds::<EvidenceU8>(one, two, 1.0 / 255.0);
        holds::<EvidenceF32>(one, two, f32::EPSILON);
    }

    // More free in a sensor's masses never makes the fused cell less free: PCR6 only (the Josang rules are not
    // monotone, see `josang_rules_are_not_monotone`).
    #[test]
    fn pcr6_is_monotone(state in masses(), sensor in masses(), more in 0.0..=1.0f32) {
        let freer = Masses::known(sensor.free() + more * sensor.uncertain(), sensor.occupied());
        prop_assume!(freer.is_ok());
        let fuse = |sensor| {
            fused(FusionRule::default(), EvidenceU16::from_masses(state), EvidenceU16::from_masses(sensor)).unwrap()
        };
        let (less, more) = (fuse(sensor), fuse(freer.unwrap()));
        prop_assert!(more.free_steps() + 1 >= less.free_steps(), "{less:?} {more:?}");
        prop_assert!(more.occupied_steps() <= less.occupied_steps() + 1, "{less:?} {more:?}");
    }

    // The kernel of slices is the kernel of one cell, whatever the length; also where each cell of the sensor says
    // free or occupied, not both.
    #[test]
    fn slices_are_fused_cell_by_cell(
        pairs in prop::collection::vec((masses(), masses()), 0..130),
        is_one_sided: bool,
    ) {
        let one_side = |m: Masses| {
            let known = if m.free() > m.occupied() { (m.free(), 0.0) } else { (0.0, m.occupied()) };
            Masses::known(known.0, known.1).unwrap()
        };
        let pairs: Vec<_> = pairs.into_iter().map(|(a, b)| (a, if is_one_sided { one_side(b) } else { b })).collect();
        for operator in FusionOperator::ALL {
            let rule = FusionRule::new(operator);
            let mut state: Vec<_> = pairs.iter().map(|p| EvidenceU16::from_masses(p.0)).collect();
            let sensor: Vec<_> = pairs.iter().map(|p| EvidenceU16::from_masses(p.1)).collect();
            let single: Vec<_> = state.iter().zip(&sensor).map(|(a, b)| fused(rule, *a, *b).unwrap()).collect();
            let conflicts = state.iter().zip(&sensor).filter(|(a, b)| {
                let wide = |v: u16| u32::from(v);
                wide(a.free_steps()) * wide(b.occupied_steps()) + wide(a.occupied_steps()) * wide(b.free_steps()) > 0
            });
            let conflicts = conflicts.count() as u32;
            let report = fuse(rule, &mut state, &sensor).unwrap();
            prop_assert_eq!(&state, &single);
            prop_assert_eq!(report.conflicts, conflicts);
            prop_assert!((report.conflict_mass > 0.0) == (conflicts > 0));
        }
    }
}

#[test]
fn josang_rules_are_not_monotone() {
    // (0, .8, .2) + (.9, 0, .1) against (.1, .8, .1) + (.9, 0, .1): more free gives more occupied under the average.
    let cell = |f, o| EvidenceF32::from_masses(Masses::known(f, o).unwrap());
    for operator in [FusionOperator::JosangAverage, FusionOperator::JosangCumulative] {
        let fuse = |one| {
            fused(rule(operator, 0.0), one, cell(0.9, 0.0))
                .unwrap()
                .masses()
                .occupied()
        };
        let (less, more) = (fuse(cell(0.0, 0.8)), fuse(cell(0.1, 0.8)));
        assert!(more > less, "{operator}: {less} {more}");
    }
}

#[test]
fn a_total_conflict_is_counted() {
    let cell = |f, o| EvidenceU16::from_masses(Masses::known(f, o).unwrap());
    let mut state = [cell(1.0, 0.0), cell(0.5, 0.0), EvidenceU16::VACUOUS];
    let sensor = [cell(0.0, 1.0), cell(0.0, 0.5), cell(0.0, 0.5)];
    let report = fuse(
        FusionRule::new(FusionOperator::DempsterShafer),
        &mut state,
        &sensor,
    )
    .unwrap();
    assert_eq!((report.conflicts, report.undefined), (2, 1));
    assert!((report.conflict_mass - 1.25).abs() < 1e-3, "{report:?}");
    assert!(state[0].is_vacuous());
}

#[test]
fn a_vacuous_input_is_not_neutral_under_the_average() {
    let rule = FusionRule::new(FusionOperator::JosangAverage);
    let mut cell = EvidenceU16::from_masses(Masses::known(0.0, 0.9).unwrap());
    for expected in [0.818, 0.692, 0.529] {
        cell = fused(rule, cell, EvidenceU16::VACUOUS).unwrap();
        assert!((cell.masses().occupied() - expected).abs() < 1e-3, "{cell:?}");
    }
}

#[test]
fn refused_fusions_change_nothing() {
    let masses = Masses::known(0.3, 0.3).unwrap();
    let mut bytes = [EvidenceU8::from_masses(masses)];
    for operator in [FusionOperator::DempsterShafer, FusionOperator::JosangCumulative] {
        let other = [EvidenceU8::VACUOUS];
        assert_eq!(
            fuse(FusionRule::new(operator), &mut bytes, &other),
            Err(Error::UnsupportedFusion)
        );
    }
    assert_eq!(bytes[0], EvidenceU8::from_masses(masses));
    let mut words = [EvidenceU16::VACUOUS; 2];
    let short = fuse(FusionRule::default(), &mut words, &[EvidenceU16::VACUOUS]);
    assert_eq!(short, Err(Error::LengthMismatch { needed: 2, given: 1 }));
    for floor in [f32::NAN, -0.1, 1.0, f32::INFINITY] {
        let bad = rule(FusionOperator::DempsterShafer, floor);
        assert!(matches!(
            fuse(bad, &mut words, &[EvidenceU16::VACUOUS; 2]),
            Err(Error::InvalidParameter(_))
        ));
    }
    for (f, o, u) in [
        (0.5, 0.6, 0.0),
        (-0.1, 0.5, 0.6),
        (f32::NAN, 0.0, 1.0),
        (0.2, 0.2, 0.2),
        (0.0, f32::INFINITY, 0.0),
    ] {
        assert_eq!(Masses::new(f, o, u), Err(Error::InvalidMasses), "{f} {o} {u}");
    }
    for operator in FusionOperator::ALL {
        assert_eq!(operator.as_str().parse(), Ok(operator));
    }
    assert_eq!(
        "PCR6".parse::<FusionOperator>(),
        Err(Error::UnknownFusionOperator)
    );
}

/// Where f32 can no longer divide by Dempster's norm, and with inputs whose sum is a rounding above the whole.
#[test]
fn f32_masses_stay_masses_at_the_limits() {
    let cell = |f, o| EvidenceF32::from_masses(Masses::known(f, o).unwrap());
    let check = |state: EvidenceF32, conflict: f32| {
        let masses = state.masses();
        let (f, o) = (masses.free(), masses.occupied());
        assert!((0.0..=1.0).contains(&f) && (0.0..=1.0).contains(&o), "{f} {o}");
        assert!(f + o <= 1.0 + f32::EPSILON, "{f} {o}");
        assert!((0.0..=1.0).contains(&conflict), "{conflict}");
    };
    for operator in FusionOperator::ALL {
        let rule = FusionRule {
            operator,
            ignorance_floor: 0.0,
        };
        for against in [0.7, 0.999, 1.0] {
            for fusions in 0..120 {
                let mut state = [cell(0.5, 0.0)];
                for _ in 0..fusions {
                    fuse(rule, &mut state, &[cell(0.0, against)]).unwrap();
                }
                let report = fuse(rule, &mut state, &[cell(1.0, 0.0)]).unwrap();
                check(state[0], report.conflict_mass);
            }
        }
    }
    // Masses that are accepted with a little too much in them.
    let mut state = [cell(1e-5, 1.0)];
    check(state[0], 0.0);
    for _ in 0..3 {
        let report = fuse(
            FusionRule::new(FusionOperator::Pcr6),
            &mut state,
            &[cell(0.0, 0.7)],
        )
        .unwrap();
        check(state[0], report.conflict_mass);
    }
}
