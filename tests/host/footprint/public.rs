//! Whether the probe calls all there is to call.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::firmware::package;

/// Names of core's `pub fn`s that the probe's text does not hold.
pub fn functions_not_named_in_the_probe() -> BTreeSet<String> {
    let core = texts(&package().join("../../horus-core/src"));
    let probe: String = texts(&package().join("src")).concat();
    let functions: BTreeSet<String> = core.iter().flat_map(|text| public_functions(text)).collect();
    assert!(functions.len() > 50, "{} public functions", functions.len());
    let called = |name: &str| {
        [
            format!(".{name}("),
            format!("::{name}("),
            format!("{name}(opaque"),
        ]
        .iter()
        .any(|call| probe.contains(call))
    };
    functions.into_iter().filter(|name| !called(name)).collect()
}

fn public_functions(text: &str) -> impl Iterator<Item = String> {
    text.lines().filter_map(|line| {
        let line = line.trim_start();
        let name = line
            .strip_prefix("pub fn ")
            .or(line.strip_prefix("pub const fn "))?;
        Some(
            name.chars()
                .take_while(|c| c.is_alphanumeric() || *c == '_')
                .collect(),
        )
    })
}

/// All Rust files under a folder; files of tests left out.
fn texts(folder: &Path) -> Vec<String> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display())) {
        let path = entry.expect("a readable folder").path();
        if path.is_dir() {
            found.extend(texts(&path));
        } else if path.extension().is_some_and(|e| e == "rs") && !path.ends_with("tests.rs") {
            found.push(fs::read_to_string(&path).expect("a text file"));
        }
    }
    found
}
