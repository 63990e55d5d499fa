//! Prints the hashes of every scripted drive of local mapping: the same lines on the host and on the target.
#![cfg_attr(target_os = "none", no_std, no_main)]

use horus_core::evidence::{EvidenceF32, EvidenceU8, EvidenceU16, FusionOperator, FusionRule};
use horus_tests::evidence::{self, Buffers};
use horus_tests::report::{self, print};
use horus_tests::{Arena, Once, c_evidence};

horus_tests::start!(run);

fn run() -> bool {
    report::ended(all())
}

fn all() -> Result<(), horus_core::Error> {
    // The largest of them; one after the other in the same RAM.
    static ARENA: Once<Arena<{ size_of::<Buffers<EvidenceF32, i16>>() }>> = Once::new(Arena::new());
    // SAFETY: here only.
    let arena = unsafe { ARENA.take() };
    for (operator, name) in [
        (FusionOperator::Pcr6, "evidence u16: pcr6"),
        (FusionOperator::DempsterShafer, "evidence u16: dempster_shafer"),
        (FusionOperator::JosangAverage, "evidence u16: josang_average"),
        (
            FusionOperator::JosangCumulative,
            "evidence u16: josang_cumulative",
        ),
    ] {
        let buffers = arena.zeroed::<Buffers<EvidenceU16, u16>>();
        evidence::run(name, FusionRule::new(operator), buffers.split(), print)?;
    }
    // The drives that the C programs repeat.
    for (operator, name) in [
        (FusionOperator::Pcr6, "c: evidence, pcr6"),
        (FusionOperator::DempsterShafer, "c: evidence, dempster_shafer"),
    ] {
        let buffers = arena.zeroed::<Buffers<EvidenceU16, u16>>();
        c_evidence::drive(name, operator, buffers.split(), print)?;
    }
    let bytes = arena.zeroed::<Buffers<EvidenceU8, i16>>();
    evidence::run("evidence u8: pcr6", FusionRule::default(), bytes.split(), print)?;
    for (operator, name) in [
        (FusionOperator::Pcr6, "evidence f32: pcr6"),
        (FusionOperator::DempsterShafer, "evidence f32: dempster_shafer"),
        (FusionOperator::JosangAverage, "evidence f32: josang_average"),
        (
            FusionOperator::JosangCumulative,
            "evidence f32: josang_cumulative",
        ),
    ] {
        let buffers = arena.zeroed::<Buffers<EvidenceF32, i16>>();
        evidence::run(name, FusionRule::new(operator), buffers.split(), print)?;
    }
    Ok(())
}
