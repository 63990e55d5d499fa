//! `horus-host map`: counts, layers, saving, and what cannot be a map.

use std::fs;
use std::path::Path;

use horus_host::log::msg::{Costmap, Grid, OccupancyGrid};
use horus_host::log::{LogEntry, LogReader};
use horus_host::reference::{self, CostParams};

use crate::support::{Painted, code, json, refused, run, scratch};

/// A room of 40 x 30 cells: walls, an obstacle, an unknown corner.
fn room(dir: &Path) -> String {
    let mut image = b"P5\n40 30\n255\n".to_vec();
    for row in 0..30 {
        for column in 0..40 {
            let wall = row == 0 || row == 29 || column == 0 || column == 39;
            let obstacle = (10..14).contains(&row) && (20..23).contains(&column);
            let unknown = row > 24 && column < 8;
            image.push(if wall || obstacle {
                0
            } else if unknown {
                205
            } else {
                254
            });
        }
    }
    fs::write(dir.join("room.pgm"), image).unwrap();
    let yaml = dir.join("room.yaml");
    let text = "image: room.pgm\nresolution: 0.1\norigin: [-2.0, 1.5, 0.0]\n\
                negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.19\n";
    fs::write(&yaml, text).unwrap();
    yaml.to_str().unwrap().to_owned()
}

#[test]
fn a_map_becomes_costs_and_distances() {
    let dir = scratch("map_layers");
    let yaml = room(&dir);
    let out = dir.join("out");
    let facts = json(
        &[
            "map",
            &yaml,
            "--radius",
            "0.5",
            "--out",
            out.to_str().unwrap(),
            "--json",
        ],
        0,
    );
    assert_eq!((&facts["width"], &facts["height"]), (&40.into(), &30.into()));
    assert_eq!(facts["resolution"], 0.1);
    assert_eq!(facts["origin"], serde_json::json!([-2.0, 1.5, 0.0]));
    let expected = serde_json::json!({"-1": 4 * 7, "0": 1200 - 28 - 136 - 12, "100": 136 + 12});
    assert_eq!(facts["counts"], expected);
    assert_eq!(facts["files"].as_array().unwrap().len(), 4);
    assert_eq!(fs::read_dir(&out).unwrap().count(), 4, "nothing half-written");

    let log = out.join("map.mcap");
    let message = |topic: &str| {
        LogReader::open(&log)
            .unwrap()
            .find_map(|entry| match entry.unwrap() {
                LogEntry::Message(message) if message.topic() == topic => Some(message),
                _ => None,
            })
            .unwrap()
    };
    let map: OccupancyGrid = message("/map").decode().unwrap();
    let costs: Costmap = message("/costmap_raw").decode().unwrap();
    let distances: Grid = message("/distance").decode().unwrap();
    let viewable: OccupancyGrid = message("/costmap").decode().unwrap();
    assert_eq!((map.data[0], map.data[41], viewable.data[0]), (100, -1, 100));

    // The costs of the std version, byte by byte; distances by brute force.
    let origin = reference::Pose2D::new(-2.0, 1.5, 0.0);
    let mut grid = reference::OccupancyGrid::try_new(40, 30, 0.1, origin).unwrap();
    grid.data.clone_from(&map.data);
    let params = CostParams {
        inflation_radius: 0.5,
        ..CostParams::default()
    };
    let mut reference = reference::CostMap::with_params(grid, params).unwrap();
    reference.compute_costs();
    assert_eq!(costs.data, reference.costs);
    let obstacles: Vec<(i64, i64)> = cells(&map)
        .filter(|cell| cell.2 == 100)
        .map(|cell| (cell.0, cell.1))
        .collect();
    for ((gx, gy, _), bytes) in cells(&map).zip(distances.data.as_chunks().0) {
        let squared = obstacles
            .iter()
            .map(|(x, y)| (x - gx).pow(2) + (y - gy).pow(2))
            .min()
            .unwrap();
        let metres = (squared as f64).sqrt() * 0.1;
        assert!(
            (f64::from(f32::from_le_bytes(*bytes)) - metres).abs() < 1e-6,
            "({gx}, {gy})"
        );
    }
    for name in ["occupancy.png", "costmap.png", "distance.png"] {
        let picture = Painted::read(out.join(name));
        assert_eq!(picture.size(), (40, 30), "{name}");
    }
    let occupancy = Painted::read(out.join("occupancy.png"));
    assert_eq!(occupancy.at(0, 0), [0; 3], "walls are black");
    assert_eq!(occupancy.at(5, 5), [255; 3]);
    assert_eq!(occupancy.at(2, 27), [0x70, 0x89, 0x86], "unknown, bottom left");
}

fn cells(map: &OccupancyGrid) -> impl Iterator<Item = (i64, i64, i8)> {
    let width = i64::from(map.info.width);
    (0..)
        .zip(&map.data)
        .map(move |(i, &value)| (i % width, i / width, value))
}

#[test]
fn the_same_map_gives_the_same_files() {
    let dir = scratch("map_again");
    let yaml = room(&dir);
    let bytes = ["a", "b"].map(|name| {
        let out = dir.join(name);
        assert_eq!(code(&run(&["map", &yaml, "--out", out.to_str().unwrap()])), 0);
        ["map.mcap", "costmap.png"].map(|file| fs::read(out.join(file)).unwrap())
    });
    assert!(bytes[0] == bytes[1]);
}

#[test]
fn maps_are_saved_from_files_and_logs() {
    let dir = scratch("map_save");
    let yaml = room(&dir);
    let path = |name: &str| dir.join(name).to_str().unwrap().to_owned();
    let counts = |yaml: &str| json(&["map", yaml, "--json"], 0)["counts"].clone();
    let saved = json(
        &[
            "map",
            "save",
            &yaml,
            &path("copy.yaml"),
            "--format",
            "png",
            "--json",
        ],
        0,
    );
    assert_eq!(saved["files"].as_array().unwrap().len(), 2);
    assert_eq!(counts(&path("copy.yaml")), counts(&yaml));
    assert_eq!(code(&run(&["map", &yaml, "--out", &path("out")])), 0);
    let log = path("out/map.mcap");
    for mode in ["trinary", "raw"] {
        let copy = path(&format!("{mode}.yaml"));
        let saved = json(&["map", "save", &log, &copy, "--mode", mode, "--json"], 0);
        assert_eq!(saved["resolution"], 0.1);
        assert_eq!(saved["origin"], serde_json::json!([-2.0, 1.5, 0.0]));
        assert_eq!(counts(&copy), counts(&yaml));
    }
    refused(
        &["map", "save", &log, &path("x.yaml"), "--topic", "/none"],
        &["/none", "/costmap, /map"],
    );
    refused(
        &["map", "save", &log, &path("x.yaml"), "--mode", "scale"],
        &["use png"],
    );
    refused(&["map", "save", &yaml, &yaml], &["overwritten"]);
    refused(&["map", "save", &yaml, &path("x.pgm")], &["cannot be the name"]);
    refused(
        &["map", "save", &path("none.yaml"), &path("x.yaml")],
        &["none.yaml"],
    );
    refused(
        &["map", "save", &yaml, &path("no/such/x.yaml")],
        &["cannot write", "x.pgm"],
    );
    assert!(!Path::new(&path("x.yaml")).exists());
}

#[test]
fn what_is_no_map() {
    let dir = scratch("map_bad");
    let yaml = room(&dir);
    let path = |name: &str| dir.join(name).to_str().unwrap().to_owned();
    refused(&["map", &path("none.yaml")], &["none.yaml"]);
    fs::write(dir.join("bad.yaml"), "image: [\n").unwrap();
    refused(&["map", &path("bad.yaml")], &["bad.yaml", "line"]);
    fs::write(dir.join("huge.pgm"), "P5 100000 100000 255\n").unwrap();
    let text = fs::read_to_string(&yaml).unwrap();
    fs::write(dir.join("huge.yaml"), text.replace("room.pgm", "huge.pgm")).unwrap();
    refused(&["map", &path("huge.yaml")], &["100000 x 100000", "not possible"]);
    refused(&["map", &yaml, "--radius", "-1"], &["inflation_radius"]);
    refused(&["map", &yaml, "--max-distance", "0"], &["above zero"]);
    refused(
        &[
            "map",
            &yaml,
            "--radius",
            "1000",
            "--scaling",
            "0",
            "--out",
            &path("o"),
        ],
        &["radius"],
    );
    fs::write(dir.join("occupancy.png"), "not a picture").unwrap();
    fs::write(dir.join("own.yaml"), text.replace("room.pgm", "occupancy.png")).unwrap();
    refused(
        &["map", &path("own.yaml"), "--out", dir.to_str().unwrap()],
        &["neither"],
    );
    fs::copy(dir.join("room.pgm"), dir.join("occupancy.png")).unwrap();
    refused(
        &["map", &path("own.yaml"), "--out", dir.to_str().unwrap()],
        &["overwritten"],
    );
    for arguments in [
        &["map"][..],
        &["map", &yaml, "--unknown", "maybe"],
        &["map", "save", &yaml],
    ] {
        assert_eq!(code(&run(arguments)), 2, "{arguments:?}");
    }
}
