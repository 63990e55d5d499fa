//! Long sequences of fusions: errors do not add up.

use horus_core::evidence::{
    EvidenceF32, EvidenceU8, EvidenceU16, FusionOperator, FusionRule, MassCell, Masses, fuse,
};
use horus_host::reference::evidence as std_version;

/// Fusions in a sequence.
const FUSIONS: u32 = 100_000;

/// The largest difference to the f64 version over a long sequence of one sensor's readings: mostly free, then mostly
/// occupied, then either, again and again.
fn drift<M: MassCell>(operator: FusionOperator, floor: f32) -> f64 {
    let rule = FusionRule {
        operator,
        ignorance_floor: floor,
    };
    let reference = std_version::FusionOperator::from_name(operator.as_str()).unwrap();
    let (mut cell, mut exact, mut noise, mut most) =
        ([M::VACUOUS], std_version::Masses::VACUOUS, 1u32, 0.0f64);
    for i in 0..FUSIONS {
        noise ^= noise << 13;
        noise ^= noise >> 17;
        noise ^= noise << 5;
        let free_of_eight = [7, 1, 4][(i / 500 % 3) as usize];
        let (f, o) = if noise % 8 < free_of_eight {
            (0.4, 0.0)
        } else {
            (0.0, 0.7)
        };
        fuse(rule, &mut cell, &[M::from_masses(Masses::known(f, o).unwrap())]).unwrap();
        let seen = std_version::Masses::known(f64::from(f), f64::from(o));
        exact = std_version::fuse(reference, f64::from(floor), exact, seen).unwrap();
        let got = cell[0].masses();
        most = most
            .max((f64::from(got.free()) - exact.free).abs())
            .max((f64::from(got.occupied()) - exact.occupied).abs());
        assert!((got.free() + got.occupied() + got.uncertain() - 1.0).abs() <= 2.0 * f32::EPSILON);
    }
    most
}

#[test]
fn pcr6_stays_within_its_bound() {
    // q (1 + w)^2 / w^3 for sensor masses of at least w = 0.4.
    let bound = |full: f64| 0.5 / full * 1.4f64.powi(2) / 0.4f64.powi(3);
    let (words, bytes) = (
        drift::<EvidenceU16>(FusionOperator::Pcr6, 0.0),
        drift::<EvidenceU8>(FusionOperator::Pcr6, 0.0),
    );
    println!(
        "u16 {words:e} of {:e}, u8 {bytes:e} of {:e}",
        bound(65_535.0),
        bound(255.0)
    );
    assert!(words <= bound(65_535.0), "{words}");
    assert!(bytes <= bound(255.0), "{bytes}");
    let floats = drift::<EvidenceF32>(FusionOperator::Pcr6, 0.0);
    println!("f32 {floats:e}");
    assert!(floats <= 2e-6, "{floats}");
}

#[test]
fn the_average_forgets_its_errors() {
    let words = drift::<EvidenceU16>(FusionOperator::JosangAverage, 0.0);
    let bytes = drift::<EvidenceU8>(FusionOperator::JosangAverage, 0.0);
    let floats = drift::<EvidenceF32>(FusionOperator::JosangAverage, 0.0);
    println!("u16 {words:e}, u8 {bytes:e}, f32 {floats:e}");
    assert!(
        words <= 1e-4 && bytes <= 2e-2 && floats <= 2e-6,
        "{words} {bytes} {floats}"
    );
}

#[test]
fn the_floor_bounds_the_other_two() {
    for operator in [FusionOperator::DempsterShafer, FusionOperator::JosangCumulative] {
        let words = drift::<EvidenceU16>(operator, 0.02);
        let floats = drift::<EvidenceF32>(operator, 0.02);
        println!("{operator}: u16 {words:e}, f32 {floats:e}");
        assert!(words <= 2e-2 && floats <= 1e-4, "{operator}: {words} {floats}");
    }
}
