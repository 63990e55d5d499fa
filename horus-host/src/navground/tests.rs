use horus_core::prelude::Footprint;

use super::{ConfigError, LocalMapFile};
use crate::yaml::YamlError;

/// What navground 0.7.0 dumps.
const DUMP: &str = "\
type: LocalGridMap
external_lidars:
  - front
  - rear
external_odometry: odom
footprint: circular
height: 120
include_transformation: true
name: map
resolution: 0.0500000007
width: 200
";

#[test]
fn what_navground_writes() {
    let expected = LocalMapFile {
        width: 200,
        height: 120,
        resolution: 0.05,
        include_transformation: true,
        external_lidars: vec!["front".into(), "rear".into()],
        external_odometry: "odom".into(),
        footprint: Footprint::Circular,
        radius: 0.0,
        name: "map".into(),
    };
    assert_eq!(LocalMapFile::parse(DUMP), Ok(expected));
}

#[test]
fn defaults() {
    let file = LocalMapFile::parse("type: LocalGridMap\nexternal_lidars:\n  []\nname: \"\"\n").unwrap();
    assert_eq!((file.width, file.height, file.resolution), (10, 10, 0.1));
    assert_eq!(file.footprint, Footprint::Rectangular);
    let file = LocalMapFile::parse("type: LocalGridMap\nfootprint: none\nradius: 1\n").unwrap();
    assert_eq!((file.footprint, file.radius), (Footprint::None, 1.0));
}

#[test]
fn errors_name_key_and_line() {
    let long = format!("name: {}", "x".repeat(33));
    for (lines, words) in [
        ("width: ten", "line 2: width: a whole number is expected, not ten"),
        ("width: 2.5", "line 2: width: a whole number is expected, not 2.5"),
        (
            "height: -1",
            "line 2: height: a property's value has the wrong type or range",
        ),
        (
            "width: 5\nresolution: 0",
            "line 3: resolution: resolution 0 m is not finite and above zero",
        ),
        (
            "resolution: .nan",
            "line 2: resolution: resolution NaN m is not finite and above zero",
        ),
        (
            "radius: -0.5",
            "line 2: radius: radius must be finite and not negative",
        ),
        (
            "include_transformation: 3",
            "line 2: include_transformation: true or false is expected, not 3",
        ),
        (
            "footprint: round",
            "line 2: footprint: a footprint is rectangular, circular or none",
        ),
        (
            "\nexternal_lidars: [a, b, a]",
            "line 3: external_lidars: two lidars have the same name",
        ),
        (
            "external_lidars: [a, 3]",
            "line 2: external_lidars: a list of texts is expected",
        ),
        (
            "external_lidars: a",
            "line 2: external_lidars: a list of texts is expected",
        ),
        (&long, "line 2: name: a name of 33 bytes is longer than 32"),
        (
            "width: 3\nwidth: 4",
            "line 3: width: the key is given twice, first in line 2",
        ),
        (
            "width: 3\ntype: LocalGridMap",
            "line 3: type: the key is given twice, first in line 1",
        ),
        (
            "depth: 3",
            "line 2: depth: no property has this name; there are external_lidars, ",
        ),
    ] {
        let error = LocalMapFile::parse(&format!("type: LocalGridMap\n{lines}\n")).unwrap_err();
        assert!(error.to_string().starts_with(words), "{error}");
    }
}

#[test]
fn what_is_no_configuration() {
    for text in [
        "",
        "- 1\n",
        "just text",
        "type: LocalGridMap\n---\ntype: LocalGridMap\n",
    ] {
        let error = LocalMapFile::parse(text).unwrap_err();
        assert!(
            matches!(error, ConfigError::Yaml(YamlError::NoMapping(_))),
            "{text:?}: {error}"
        );
    }
    assert_eq!(LocalMapFile::parse("width: 3"), Err(ConfigError::NoType));
    let error = LocalMapFile::parse("width: 3\ntype: Lidar\n").unwrap_err();
    assert_eq!(
        error.to_string(),
        "line 2: type: a local map has the type LocalGridMap, not Lidar"
    );
    let error = LocalMapFile::parse("type: [\n").unwrap_err();
    assert!(
        matches!(error, ConfigError::Yaml(YamlError::Syntax { line: 1.., .. })),
        "{error}"
    );
    let large = "#".repeat(LocalMapFile::MOST_BYTES + 1);
    assert_eq!(
        LocalMapFile::parse(&large),
        Err(ConfigError::TooLarge(large.len()))
    );
    let deep = "[".repeat(LocalMapFile::MOST_BYTES);
    assert!(LocalMapFile::parse(&deep).is_err());
}
