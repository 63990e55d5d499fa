//! `horus-host demo`: its files, its summary, and what stands in its logs.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::support::{code, json, run, scratch, stderr};
use horus_host::log::msg::{Costmap, LaserScan, OccupancyGrid, TFMessage};
use horus_host::log::{LogEntry, LogReader, ReadEnd, cost_to_viewable};
use horus_host::tf::{TfBuffer, Transform};

#[test]
fn a_short_demo_agrees_and_leaves_all_its_files() {
    let out = scratch("demo_files").join("new/deeper");
    let dir = out.to_str().unwrap();
    let summary = json(&["demo", "--seconds", "3", "--out", dir, "--json"], 0);
    assert_eq!(summary["scans"], 30);
    assert_eq!(summary["cells_compared"], 30 * 2 * 200 * 200);
    assert_eq!(summary["mismatches"], 0);
    assert_eq!(
        (&summary["width"], &summary["height"]),
        (&200.into(), &200.into())
    );
    assert_eq!(summary["resolution"].as_f64().map(|r| r as f32), Some(0.05));
    assert_eq!(summary["parameters"]["decay"], "polynomial");
    assert_eq!(summary["parameters"]["lethal_cost"], 253);
    assert_eq!(summary["field"], "u8");
    assert_eq!(summary["effective_radius_cells"], 4);
    assert_eq!(summary["skipped_scans"], 0);
    for key in ["core_us_per_scan", "std_us_per_scan"] {
        assert!(summary[key].as_f64().unwrap() > 0.0, "{key}");
    }
    let ram = summary["ram_bytes_per_cell"].as_f64().unwrap();
    assert!(
        (2.25..2.6).contains(&ram),
        "{ram} bytes per cell, tables and beams included"
    );

    let written = fs::read_to_string(out.join("summary.json")).unwrap();
    assert_eq!(
        serde_json::from_str::<serde_json::Value>(&written).unwrap(),
        summary
    );
    let mut names: Vec<_> = fs::read_dir(&out)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    let expected = [
        "core.mcap",
        "costmap.png",
        "difference.png",
        "occupancy.png",
        "std.mcap",
        "summary.json",
    ];
    assert_eq!(names, expected, "no probes, no halves");
    for name in expected.iter().filter(|name| name.ends_with("png")) {
        assert!(
            fs::read(out.join(name)).unwrap().starts_with(b"\x89PNG"),
            "{name}"
        );
    }

    let compared = json(
        &[
            "compare",
            &format!("{dir}/core.mcap"),
            &format!("{dir}/std.mcap"),
            "--json",
        ],
        0,
    );
    assert_eq!(compared["equal"], true);
    assert_eq!(compared["topics"].as_array().unwrap().len(), 6);
    check_log(&out.join("core.mcap"));
}

/// Maps come with a connected tree of transforms, exact and viewable costs fit each other.
fn check_log(path: &Path) {
    let mut tf = TfBuffer::new();
    let mut maps: BTreeMap<u64, OccupancyGrid> = BTreeMap::new();
    let mut viewable: BTreeMap<u64, OccupancyGrid> = BTreeMap::new();
    let mut exact: BTreeMap<u64, Costmap> = BTreeMap::new();
    let mut scans = 0;
    let mut reader = LogReader::open(path).unwrap();
    for entry in &mut reader {
        let message = match entry.unwrap() {
            LogEntry::Message(message) => message,
            LogEntry::Metadata { name, values } => {
                assert_eq!(name, "horus");
                assert_eq!(values["side"], "core");
                assert_eq!(values["version"], env!("CARGO_PKG_VERSION"));
                assert_eq!((&*values["width"], &*values["resolution"]), ("200", "0.05"));
                assert_eq!(values["decay"], "polynomial");
                continue;
            }
        };
        let stamp_ns = message.log_time_ns;
        match message.topic() {
            "/local_map" => drop(maps.insert(stamp_ns, message.decode().unwrap())),
            "/costmap" => drop(viewable.insert(stamp_ns, message.decode().unwrap())),
            "/costmap_raw" => drop(exact.insert(stamp_ns, message.decode().unwrap())),
            "/scan" => {
                let scan: LaserScan = message.decode().unwrap();
                assert_eq!((scan.ranges.len(), &*scan.header.frame_id), (360, "laser"));
                scans += 1;
            }
            topic => {
                assert!(
                    maps.keys().all(|&map| map < stamp_ns),
                    "transforms come before the map"
                );
                for stamped in message.decode::<TFMessage>().unwrap().transforms {
                    let (t, q) = (stamped.transform.translation, stamped.transform.rotation);
                    let transform = Transform {
                        translation: [t.x, t.y, t.z],
                        rotation: [q.x, q.y, q.z, q.w],
                    };
                    let (parent, child) = (&stamped.header.frame_id, &stamped.child_frame_id);
                    let at = stamped.header.stamp.to_ns().unwrap();
                    assert!(at <= stamp_ns);
                    tf.insert(parent, child, at, transform, topic == "/tf_static")
                        .unwrap();
                }
            }
        }
    }
    assert_eq!(reader.end(), Some(ReadEnd::Complete));
    assert_eq!((scans, maps.len(), viewable.len(), exact.len()), (30, 30, 30, 30));
    for (stamp_ns, map) in &maps {
        let (view, raw) = (&viewable[stamp_ns], &exact[stamp_ns]);
        assert_eq!(map.header.stamp.to_ns(), Some(*stamp_ns));
        assert_eq!((&map.header, &map.info), (&view.header, &view.info));
        assert_eq!(map.header, raw.header);
        assert_eq!(map.info.origin, raw.metadata.origin);
        let costs = raw.data.iter().map(|&cost| cost_to_viewable(cost, 253));
        assert!(costs.eq(view.data.iter().copied()));
        // The robot stands in the middle of its map.
        let robot = tf.lookup(&map.header.frame_id, "base_link", *stamp_ns).unwrap();
        let corner = map.info.origin.position;
        assert!((robot.x - corner.x - 5.0).abs() < 0.03 && (robot.y - corner.y - 5.0).abs() < 0.03);
        tf.lookup("map", "laser", *stamp_ns).unwrap();
    }
    let last = maps.values().last().unwrap();
    assert!([-1, 0, 100].iter().all(|value| last.data.contains(value)));
}

#[test]
fn the_same_demo_gives_the_same_bytes_and_its_log_can_be_replayed() {
    let dir = scratch("demo_twice");
    let out = |name: &str| dir.join(name).to_str().unwrap().to_owned();
    let demo = [
        "demo",
        "--seconds",
        "1",
        "--width",
        "101",
        "--height",
        "64",
        "--preset",
        "nav2",
    ];
    for name in ["a", "b"] {
        let output = run(&[
            &demo[..],
            &["--model", "accumulate", "--keep-costs", "--out", &out(name)],
        ]
        .concat());
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        assert!(
            String::from_utf8(output.stdout)
                .unwrap()
                .contains("mismatches      0\n")
        );
    }
    for name in ["core.mcap", "std.mcap"] {
        let bytes = |side: &str| fs::read(dir.join(side).join(name)).unwrap();
        assert_eq!(bytes("a"), bytes("b"), "{name}");
    }
    let again = out("again");
    let log = format!("{}/core.mcap", out("a"));
    let replay = [
        "replay", &log, "--width", "101", "--height", "64", "--preset", "nav2",
    ];
    let summary = json(
        &[&replay[..], &["--model", "accumulate", "--out", &again, "--json"]].concat(),
        0,
    );
    assert_eq!(summary["scans"], 10);
    // Poses pass through quaternions, so only what they do not touch is equal for certain.
    let compared = run(&["compare", &log, &format!("{again}/core.mcap"), "--json"]);
    let compared: serde_json::Value = serde_json::from_slice(&compared.stdout).unwrap();
    let topics = compared["topics"].as_array().unwrap();
    let scan = topics.iter().find(|topic| topic["topic"] == "/scan").unwrap();
    assert_eq!(
        (&scan["messages_b"], &scan["differing_messages"]),
        (&10.into(), &0.into())
    );
}

#[test]
fn maps_can_be_logged_less_often() {
    let out = scratch("demo_log_every");
    let dir = out.to_str().unwrap();
    let small = ["--width", "40", "--height", "40", "--seconds", "1"];
    json(
        &[&["demo", "--out", dir, "--log-every", "4", "--json"], &small[..]].concat(),
        0,
    );
    let log = format!("{dir}/core.mcap");
    let compared = json(&["compare", &log, &log, "--json"], 0);
    let messages = |name: &str| {
        let topics = compared["topics"].as_array().unwrap();
        let topic = topics.iter().find(|topic| topic["topic"] == name);
        topic.unwrap()["messages_a"].clone()
    };
    assert_eq!(
        (
            messages("/scan"),
            messages("/local_map"),
            messages("/costmap_raw")
        ),
        (10.into(), 3.into(), 3.into())
    );
}
