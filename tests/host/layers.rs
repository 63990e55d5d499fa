//! Every module of core uses only modules left of it in the layer list of its crate docs.

use std::fs;
use std::path::{Path, PathBuf};

/// From the lowest to the highest.
const LAYERS: [&str; 13] = [
    "error", "math", "storage", "geometry", "walk", "grid", "raycast", "distance", "costmap", "evidence",
    "local", "frames", "c_abi",
];
/// Modules that may name everything.
const TOP: [&str; 2] = ["lib", "prelude"];

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

fn rank(module: &str) -> usize {
    LAYERS
        .iter()
        .position(|l| *l == module)
        .unwrap_or_else(|| panic!("module {module} has no layer"))
}

#[test]
fn dependencies_point_one_way() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../horus-core/src");
    let mut files = Vec::new();
    sources(&root, &mut files);
    assert!(files.len() > 20, "{} files", files.len());
    let mut uses = 0;
    for file in files {
        let module = file
            .strip_prefix(&root)
            .unwrap()
            .iter()
            .next()
            .unwrap()
            .to_str()
            .unwrap();
        let module = module.strip_suffix(".rs").unwrap_or(module);
        if TOP.contains(&module) {
            continue;
        }
        let text = fs::read_to_string(&file).unwrap();
        // Code only: doc comments may link anywhere, tests of a module are part of it.
        for line in text.lines().filter(|l| !l.trim_start().starts_with("//")) {
            for used in line.split("crate::").skip(1) {
                let used: String = used
                    .chars()
                    .take_while(|c| c.is_alphanumeric() || *c == '_')
                    .collect();
                uses += 1;
                assert!(
                    rank(&used) <= rank(module),
                    "{}: {module} must not use {used}",
                    file.display()
                );
            }
        }
    }
    assert!(uses > 30, "{uses} uses");
}
