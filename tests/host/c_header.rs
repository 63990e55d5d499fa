//! The checked-in C header is the one that the C ABI's source gives.
//!
//! After a change of the C ABI, write it anew:
//! `HORUS_WRITE_HEADER=1 cargo test -p horus-tests --test c_header`

use std::path::{Path, PathBuf};
use std::{env, fs};

/// What the header describes, in its order.
const SOURCES: [&str; 25] = [
    "c_abi/version.rs",
    "c_abi/sizes.rs",
    "c_abi/status.rs",
    "geometry/pose.rs",
    "geometry/rect.rs",
    "c_abi/geometry.rs",
    "c_abi/grid.rs",
    "c_abi/grid_reads.rs",
    "c_abi/scan.rs",
    "c_abi/cost_map/map.rs",
    "c_abi/cost_map/params.rs",
    "c_abi/cost_map/writes.rs",
    "c_abi/cost_map/update.rs",
    "c_abi/cost_map/reads.rs",
    "c_abi/distance/map.rs",
    "c_abi/distance/reads.rs",
    "c_abi/distance/rays.rs",
    "c_abi/local_map/map.rs",
    "c_abi/local_map/writes.rs",
    "c_abi/local_map/update.rs",
    "c_abi/local_map/reads.rs",
    "c_abi/evidence/config.rs",
    "c_abi/evidence/mapping.rs",
    "c_abi/evidence/tick.rs",
    "c_abi/evidence/reads.rs",
];

fn core() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../horus-core")
}

fn header() -> String {
    let core = core();
    let config = cbindgen::Config::from_file(core.join("cbindgen.toml")).unwrap();
    let mut builder = cbindgen::Builder::new().with_config(config);
    for source in SOURCES {
        builder = builder.with_src(core.join("src").join(source));
    }
    let mut text = Vec::new();
    builder.generate().unwrap().write(&mut text);
    String::from_utf8(text).unwrap()
}

#[test]
fn the_header_is_current() {
    let path = core().join("include/horus.h");
    let (expected, found) = (header(), fs::read_to_string(&path).unwrap_or_default());
    if expected == found {
        return;
    }
    if env::var_os("HORUS_WRITE_HEADER").is_some() {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, expected).unwrap();
        return;
    }
    let line = expected.lines().zip(found.lines()).position(|(e, f)| e != f);
    let line = line.map_or("its end".into(), |line| format!("line {}", line + 1));
    panic!("include/horus.h is stale from {line} on: see the command in this test's documentation");
}

/// Names of the functions that the folder's files export.
fn exported(folder: &Path, names: &mut Vec<String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            exported(&path, names);
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        for after in text.split("#[unsafe(no_mangle)]").skip(1) {
            let (_, name) = after.split_once(" fn ").unwrap();
            names.push(name.split_once('(').unwrap().0.into());
        }
    }
}

#[test]
fn every_function_is_in_the_header() {
    let header = header();
    let mut names = Vec::new();
    exported(&core().join("src/c_abi"), &mut names);
    assert!(names.len() > 40, "{names:?}");
    for name in names {
        assert!(header.contains(&format!("{name}(")), "{name}");
    }
}

#[test]
fn the_readme_shows_the_example() {
    let readme = fs::read_to_string(core().join("../README.md")).unwrap();
    let example = fs::read_to_string(core().join("examples/c/firmware.c")).unwrap();
    let shown = readme.split("```c\n").nth(1).and_then(|s| s.split("```").next());
    let shown = shown.expect("the README shows C");
    assert!(example.contains(shown), "README.md and firmware.c differ");
}
