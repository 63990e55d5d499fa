//! `horus-host replay --map local`: navground's local map, core and std version in lockstep.

use std::fs;
use std::path::Path;

use crate::support::{S, TestLog, code, json, refused, run, scan_at, scratch, stderr};
use horus_host::log::msg::{LaserScan, OccupancyGrid};
use horus_host::log::{LogEntry, LogReader};

const TENTH: u64 = S / 10;

/// Twenty scans of a driving robot.
fn drive(path: &Path) {
    let mut log = TestLog::with_mount(path);
    for tenths in 0..=30 {
        log.robot(tenths * TENTH);
    }
    for tenths in 5..25 {
        let scan = scan_at(tenths * TENTH);
        let mut ranges = scan.ranges.clone();
        for (i, range) in ranges.iter_mut().enumerate() {
            match (i + tenths as usize) % 11 {
                0 => *range = f32::INFINITY,
                1 => *range = f32::NAN,
                2 => *range = -1.0,
                _ => {}
            }
        }
        log.scan(&LaserScan { ranges, ..scan });
    }
    log.finish();
}

/// The occupancy values that a log's topic holds in its last message.
fn last_map(path: &Path, topic: &str) -> OccupancyGrid {
    let mut last = None;
    for entry in LogReader::open(path).unwrap() {
        if let LogEntry::Message(message) = entry.unwrap()
            && message.topic() == topic
        {
            last = Some(message.decode().unwrap());
        }
    }
    last.expect("a map")
}

#[test]
fn a_replay_in_lockstep() {
    let dir = scratch("local_replay");
    let (log, config, out) = (dir.join("drive.mcap"), dir.join("map.yaml"), dir.join("out"));
    drive(&log);
    fs::write(
        &config,
        "type: LocalGridMap\nwidth: 80\nheight: 60\nresolution: 0.1\nfootprint: circular\nradius: 0.3\n\
         external_lidars: [laser]\nexternal_odometry: odom\n",
    )
    .unwrap();
    let [log, config, out] = [&log, &config, &out].map(|path| path.to_str().unwrap());
    let arguments = [
        "replay", log, "--map", "local", "--config", config, "--out", out, "--json",
    ];
    let summary = json(&arguments, 0);
    assert_eq!(summary["scans"], 20);
    assert_eq!(summary["mismatches"], 0);
    assert_eq!(summary["model"], "local");
    assert_eq!((&summary["width"], &summary["height"]), (&80.into(), &60.into()));
    assert_eq!(summary["cells_compared"], 20 * 2 * 80 * 60);

    let [core, std] = ["core.mcap", "std.mcap"].map(|name| Path::new(out).join(name));
    let output = run(&["compare", core.to_str().unwrap(), std.to_str().unwrap()]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));

    let map = last_map(&core, "/local_map");
    assert_eq!((map.info.width, map.info.height), (80, 60));
    for value in [-1, 0, 100] {
        assert!(map.data.contains(&value), "{value}");
    }
    assert!(map.data.iter().all(|value| [-1, 0, 100].contains(value)));
    // The corner lies whole cells from the frame's origin.
    let cells = map.info.origin.position.x / 0.1;
    assert!((cells - cells.round()).abs() < 1e-5, "{cells}");
}

#[test]
fn without_a_file_the_options_give_the_size() {
    let dir = scratch("local_options");
    let log = dir.join("drive.mcap");
    drive(&log);
    let log = log.to_str().unwrap();
    let summary = json(
        &[
            "replay", log, "--map", "local", "--width", "50", "--height", "40", "--json",
        ],
        0,
    );
    assert_eq!(
        (&summary["width"], &summary["mismatches"]),
        (&50.into(), &0.into())
    );
}

#[test]
fn configurations_that_cannot_be_used() {
    let dir = scratch("local_refused");
    let log = dir.join("drive.mcap");
    drive(&log);
    let log = log.to_str().unwrap();
    let config = dir.join("map.yaml");
    let name = config.to_str().unwrap();
    let with = |text: &str, words: &[&str]| {
        fs::write(&config, text).unwrap();
        refused(&["replay", log, "--map", "local", "--config", name], words);
    };
    with(
        "type: LocalGridMap\nwidth: 10\nresolution: -1\n",
        &["map.yaml: line 3: resolution: "],
    );
    with("type: LocalGridMap\nfootprint: round\n", &["line 2: footprint: "]);
    with("type: LocalGridMap\nwidth: 0\n", &["0 x 10 cells"]);
    with(
        "type: LocalGridMap\nexternal_lidars: [a, b]\n",
        &["2 lidars are named"],
    );
    with("width: 10\n", &["type: the key is missing"]);
    refused(&["replay", log, "--config", name], &["it needs --map local"]);
    let missing = dir.join("none.yaml");
    refused(
        &[
            "replay",
            log,
            "--map",
            "local",
            "--config",
            missing.to_str().unwrap(),
        ],
        &["cannot read", "none.yaml"],
    );
}
