//! Whether the probe calls all there is to call.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::firmware::package;

/// Names of core's `pub fn`s, and of what it exports to C, that the probe's text does not hold.
pub fn functions_not_named_in_the_probe() -> BTreeSet<String> {
    let core = package().join("../../horus-core/src");
    let probe: String = texts(&package().join("src"), None).concat();
    let c_abi = core.join("c_abi");
    let rust = texts(&core, Some(&c_abi));
    let functions: BTreeSet<String> = rust
        .iter()
        .filter(|text| has_public_item(text))
        .flat_map(|text| public_functions(text))
        .collect();
    assert!(functions.len() > 80, "{} public functions", functions.len());
    let exported: BTreeSet<String> = texts(&c_abi, None)
        .iter()
        .flat_map(|text| exported_functions(text))
        .collect();
    assert!(exported.len() > 40, "{} functions for C", exported.len());
    let called = |name: &str| {
        [
            format!(".{name}("),
            format!(".{name}::<"),
            format!("::{name}("),
            format!("{name}(opaque"),
        ]
        .iter()
        .any(|call| probe.contains(call))
    };
    let missing = functions.into_iter().filter(|name| !called(name));
    let kept = |name: &str| probe.contains(&format!(" {name} as *const ()"));
    missing
        .chain(exported.into_iter().filter(|name| !kept(name)))
        .collect()
}

/// A file without one belongs to a type that only core sees, whose `pub fn`s nobody else calls.
fn has_public_item(text: &str) -> bool {
    text.lines()
        .any(|line| line.starts_with("pub ") && !line.starts_with("pub use "))
}

fn exported_functions(text: &str) -> impl Iterator<Item = String> {
    text.split("#[unsafe(no_mangle)]")
        .skip(1)
        .filter_map(|after| after.split_once(" fn ")?.1.split_once('('))
        .map(|(name, _)| name.to_owned())
}

/// Functions that are public themselves, and those of public traits that are documented.
fn public_functions(text: &str) -> impl Iterator<Item = String> {
    let (mut in_trait, mut hidden) = (false, false);
    text.lines().filter_map(move |line| {
        let starts = line.starts_with("pub trait ") && line.ends_with('{') && !hidden;
        in_trait = starts || in_trait && line != "}";
        let line = line.trim_start();
        let method = line.strip_prefix("fn ").filter(|_| in_trait && !hidden);
        hidden = line == "#[doc(hidden)]" || hidden && line.starts_with("#[");
        let name = method
            .or(line.strip_prefix("pub fn "))
            .or(line.strip_prefix("pub const fn "))?;
        Some(
            name.chars()
                .take_while(|c| c.is_alphanumeric() || *c == '_')
                .collect(),
        )
    })
}

/// All Rust files under a folder but for one folder in it; files of tests left out.
fn texts(folder: &Path, but_for: Option<&Path>) -> Vec<String> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display())) {
        let path = entry.expect("a readable folder").path();
        if but_for == Some(&path) || path.ends_with("tests") {
            continue;
        }
        if path.is_dir() {
            found.extend(texts(&path, but_for));
        } else if path.extension().is_some_and(|e| e == "rs") && !path.ends_with("tests.rs") {
            found.push(fs::read_to_string(&path).expect("a text file"));
        }
    }
    found
}
