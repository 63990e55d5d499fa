//! What core takes of a microcontroller: flash and RAM of release firmware, and no panic in it.
//!
//! Builds the programs of `tests/footprint` for the target and reads their ELF files; see the
//! table with `cargo test -p horus-tests --test footprint -- --nocapture`.

mod firmware;
mod image;
mod public;

use firmware::{Profile, build, read};
use horus_core::costmap::bit_words;
use image::Image;

const KIB: u64 = 1024;

/// Without libm; the compiler's own routines included.
struct Bound {
    program: &'static str,
    small: u64,
    fast: u64,
}

/// What the images may take: what they took, and a little room; for `cost_map` the goal.
const BOUNDS: [Bound; 9] = [
    bound("grid", 3, 3),
    bound("scan", 5, 7),
    bound("scan_accumulate", 6, 8),
    bound("cost_map", 16, 30),
    bound("cost_map_u16", 24, 46),
    bound("all", 22, 38),
    bound("distance", 7, 11),
    bound("local_map", 27, 43),
    bound("evidence", 22, 26),
];
/// What the part of libm that core uses may take; the local map, which takes angles apart, needs more of it.
const LIBM: u64 = 15 * KIB;
const LIBM_OF_LOCAL_MAPS: u64 = 16 * KIB;

impl Bound {
    fn of(&self, profile: Profile) -> u64 {
        if profile == Profile::SMALL {
            self.small
        } else {
            self.fast
        }
    }
}

const fn bound(program: &'static str, small: u64, fast: u64) -> Bound {
    Bound {
        program,
        small: small * KIB,
        fast: fast * KIB,
    }
}

// One test per profile, each of which cargo builds in a folder of its own: side by side.
#[test]
fn flash_per_feature_is_bounded_with_opt_level_s() {
    check_flash(Profile::SMALL);
}

#[test]
fn flash_per_feature_is_bounded_with_opt_level_3() {
    check_flash(Profile::RELEASE);
}

fn check_flash(profile: Profile) {
    let mut too_large = Vec::new();
    let mut table = String::from("flash, bytes          | opt-level | core  | compiler's routines | libm\n");
    let level = profile.opt_level;
    let programs: Vec<&str> = ["empty", "libm"]
        .into_iter()
        .chain(BOUNDS.map(|b| b.program))
        .collect();
    build(profile, &programs, "").expect("the images link");
    let [empty, libm] = ["empty", "libm"].map(|program| read(profile, program));
    for bound in &BOUNDS {
        let image = read(profile, bound.program);
        // libm's constants have no names: all that its own image has are taken for granted.
        let libm = image.libm_code + libm.rodata.min(image.rodata);
        let without_libm = image.flash() - empty.flash() - libm;
        let (core, runtime) = (without_libm - image.runtime_code, image.runtime_code);
        let program = bound.program;
        table += &format!("{program:21} | {level:9} | {core:5} | {runtime:19} | {libm:5}\n");
        let libm_allowed = if bound.program == "local_map" {
            LIBM_OF_LOCAL_MAPS
        } else {
            LIBM
        };
        if libm > libm_allowed {
            too_large.push(format!(
                "libm in {} at {level}: {libm}, {libm_allowed} allowed",
                bound.program
            ));
        }
        let most = bound.of(profile);
        if without_libm > most {
            too_large.push(format!(
                "{} at {level}: {without_libm}, {most} allowed",
                bound.program
            ));
        }
        check_symbols(bound.program, &image);
    }
    print!("{table}");
    assert!(too_large.is_empty(), "{too_large:#?}");
}

/// No initialised data, nothing in RAM that the program did not ask for, no heap, no formatting.
fn check_symbols(program: &str, image: &Image) {
    assert_eq!(image.data, 0, "{program}: .data");
    let storage: u64 = image.storage.iter().sum();
    let padding = 8 * image.storage.len() as u64;
    assert!(
        (storage..=storage + padding).contains(&image.bss),
        "{program}: .bss has {} bytes, its statics {storage}",
        image.bss
    );
    for unwanted in [
        "__rust_alloc",
        "__rdl_alloc",
        "__rg_alloc",
        "malloc",
        "4core3fmt",
        "panicking",
    ] {
        let found = image.names.iter().find(|name| name.contains(unwanted));
        assert_eq!(found, None, "{program} must not contain {unwanted}");
    }
}

#[test]
fn ram_is_as_documented() {
    build(Profile::RELEASE, &["cost_map", "cost_map_u16"], "").expect("the images link");
    for (program, side, field_bytes, rest) in
        [("cost_map", 200, 1, 4 * KIB), ("cost_map_u16", 160, 2, 10 * KIB)]
    {
        let map = read(Profile::RELEASE, program)
            .storage
            .into_iter()
            .max()
            .unwrap_or(0);
        let cells = u64::from(side * side);
        let bits = 4 * bit_words(side, side) as u64;
        println!(
            "{program}: {side} x {side} cells in {map} bytes, {:.3} per cell",
            map as f64 / cells as f64
        );
        // Cells and field; a source and a change bit per cell, plus O(width + height); the rest.
        let (documented, per_line) = (cells * (1 + field_bytes) + cells / 4, u64::from(8 * 2 * side));
        assert!(bits <= cells / 4 + per_line, "{bits} bytes of bits");
        assert!(
            map > documented && map <= documented + per_line + rest,
            "{program}: {map} bytes"
        );
    }
}

#[test]
fn no_panic_can_be_reached() {
    // All of core, and what C calls; then with every feature, and the kernels of `dsp`.
    for features in ["c-abi", "serde,defmt,c-abi,dsp"] {
        if let Err(linker) = build(Profile::RELEASE, &["probe"], features) {
            panic!("features [{features}]: something in core can panic:\n{linker}");
        }
    }
}

#[test]
fn no_panic_can_be_reached_with_opt_level_s() {
    build(Profile::SMALL, &["probe"], "c-abi").expect("no panic with opt-level s either");
}

#[test]
fn a_panic_would_be_noticed() {
    let linker = build(Profile::RELEASE, &["probe"], "mutant").expect_err("an index out of range can panic");
    assert!(
        linker.contains("undefined symbol: this_program_can_panic"),
        "{linker}"
    );
}

#[test]
fn every_public_function_is_probed() {
    let missing = public::functions_not_named_in_the_probe();
    assert!(
        missing.is_empty(),
        "call these in tests/footprint/src/bin/probe: {missing:?}"
    );
}
