//! `horus-host replay` on logs with every kind of hole.

use std::fs;
use std::path::{Path, PathBuf};

use crate::support::{S, TestLog, code, json, refused, run, scan_at, scratch, stderr};
use horus_host::log::msg::{LaserScan, Quaternion, Time, Transform};
use serde_json::Value;

const TENTH: u64 = S / 10;

/// Scans at 0.5, 1.0 .. 3.0 s and some that cannot be used; transforms from 1.0 to 2.0 and from 2.9
/// to 3.5 s, written after the scans that need them.
fn holey_log(path: &Path) {
    let mut log = TestLog::with_mount(path);
    for stamp_ns in [5, 10, 11, 12, 15, 14, 20, 24, 30].map(|tenths| tenths * TENTH) {
        log.scan(&scan_at(stamp_ns));
    }
    log.scan(&LaserScan {
        ranges: Vec::new(),
        ..scan_at(12 * TENTH)
    });
    log.scan(&LaserScan {
        angle_min: f32::NAN,
        ..scan_at(12 * TENTH)
    });
    log.scan(&LaserScan {
        angle_increment: f32::INFINITY,
        ..scan_at(12 * TENTH)
    });
    let mut scan = scan_at(13 * TENTH);
    scan.header.stamp = Time { sec: -1, nanosec: 0 };
    log.scan(&scan);
    let mut scan = scan_at(13 * TENTH);
    scan.header.frame_id = "elsewhere".to_owned();
    log.scan(&scan);
    for tenths in (10..=20).chain(29..=35) {
        log.robot(tenths * TENTH);
    }
    let mut broken = Transform::planar(f64::NAN, 0.0, 0.0);
    log.tf("/tf", 13 * TENTH, "odom", "base_link", broken);
    broken = Transform::planar(0.0, 0.0, 0.0);
    broken.rotation = Quaternion {
        x: 0.0,
        y: 0.0,
        z: 0.0,
        w: 0.0,
    };
    log.tf("/tf", 13 * TENTH, "odom", "base_link", broken);
    log.finish();
}

fn skipped(summary: &Value, reason: &str) -> u64 {
    summary["skipped"][reason]["scans"].as_u64().unwrap_or(0)
}

fn log_in(test: &str) -> (PathBuf, String) {
    let dir = scratch(test);
    let log = dir.join("in.mcap").to_str().unwrap().to_owned();
    (dir, log)
}

#[test]
fn unusable_scans_are_counted_by_reason_and_the_rest_agrees() {
    let (dir, log) = log_in("replay_holes");
    holey_log(Path::new(&log));
    let small = ["--width", "81", "--height", "60", "--json"];
    let summary = json(&[&["replay", &log], &small[..]].concat(), 0);
    assert_eq!(
        (&summary["scans"], &summary["mismatches"]),
        (&8.into(), &0.into())
    );
    assert_eq!(summary["cells_compared"], 8 * 2 * 81 * 60);
    assert_eq!(summary["out_of_order_scans"], 1);
    assert_eq!(summary["rejected_transforms"], 2);
    assert_eq!(summary["skipped_scans"], 6);
    for (reason, scans) in [
        ("empty", 1),
        ("invalid_fields", 2),
        ("invalid_stamp", 1),
        ("tf_unknown_frame", 1),
        ("tf_extrapolation", 1),
        ("tf_gap", 0),
    ] {
        assert_eq!(skipped(&summary, reason), scans, "{reason}");
    }
    assert_eq!(
        fs::read_dir(&dir).unwrap().count(),
        1,
        "nothing is written without --out"
    );

    let summary = json(&[&["replay", &log, "--max-gap", "0.5"], &small[..]].concat(), 0);
    assert_eq!((&summary["scans"], skipped(&summary, "tf_gap")), (&7.into(), 1));
    let text = summary["skipped"]["tf_gap"]["first"].as_str().unwrap();
    assert!(text.contains("2400000000"), "{text}");

    let output = run(&["replay", &log, "--width", "20", "--height", "20"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("1 empty (the scan has no ranges)"), "{text}");
    assert!(text.contains("out of order    1 scans"), "{text}");
}

#[test]
fn every_and_limit_thin_the_scans() {
    let (_, log) = log_in("replay_thin");
    let mut writer = TestLog::with_mount(Path::new(&log));
    for tenths in 10..30 {
        writer.robot(tenths * TENTH);
        writer.scan(&scan_at(tenths * TENTH));
    }
    writer.finish();
    let scans = |options: &[&str]| {
        let all = ["replay", &log, "--width", "30", "--height", "30", "--json"];
        json(&[&all[..], options].concat(), 0)["scans"].clone()
    };
    assert_eq!(scans(&[]), 20);
    assert_eq!(scans(&["--every", "3"]), 7);
    assert_eq!(scans(&["--limit", "4"]), 4);
    assert_eq!(scans(&["--every", "10", "--limit", "9"]), 2);
}

#[test]
fn results_are_written_where_asked_and_never_over_the_input() {
    let (dir, log) = log_in("replay_out");
    holey_log(Path::new(&log));
    let out = dir.join("out");
    let small = ["--width", "50", "--height", "50", "--out", out.to_str().unwrap()];
    let output = run(&[&["replay", &log], &small[..]].concat());
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let core = out.join("core.mcap");
    let written = fs::read(&core).unwrap();
    for name in [
        "std.mcap",
        "summary.json",
        "occupancy.png",
        "costmap.png",
        "difference.png",
    ] {
        assert!(out.join(name).is_file(), "{name}");
    }
    refused(
        &[&["replay", core.to_str().unwrap()], &small[..]].concat(),
        &["core.mcap", "would be overwritten"],
    );
    assert_eq!(fs::read(&core).unwrap(), written);
}

#[test]
fn the_topic_is_chosen_or_asked_for() {
    let (dir, log) = log_in("replay_topics");
    let both = dir.join("both.mcap").to_str().unwrap().to_owned();
    let neither = dir.join("neither.mcap").to_str().unwrap().to_owned();
    for (path, topics) in [
        (&log, ["/front", "/front"]),
        (&both, ["/scan", "/rear"]),
        (&neither, ["/front", "/rear"]),
    ] {
        let mut writer = TestLog::with_mount(Path::new(path));
        for tenths in 10..14 {
            writer.robot(tenths * TENTH);
            writer.scan_on(topics[(tenths % 2) as usize], &scan_at(tenths * TENTH));
        }
        writer.finish();
    }
    let small = ["--width", "30", "--height", "30", "--json"];
    let scans = |arguments: &[&str]| json(&[&["replay"], arguments, &small[..]].concat(), 0)["scans"].clone();
    assert_eq!(scans(&[&log]), 4, "the only one");
    assert_eq!(scans(&[&both]), 2, "/scan");
    assert_eq!(scans(&[&neither, "--scan", "/rear"]), 2);
    refused(
        &["replay", &neither],
        &["neither.mcap", "/front, /rear", "--scan"],
    );
    refused(
        &["replay", &log, "--scan", "/nothing"],
        &["in.mcap", "no topic /nothing", "/front"],
    );
    refused(
        &["replay", &log, "--scan", "/tf"],
        &["topic /tf holds tf2_msgs/msg/TFMessage", "/front"],
    );
}

#[test]
fn the_frames_are_selectable() {
    let (dir, log) = log_in("replay_frames");
    let mut writer = TestLog::create(Path::new(&log));
    writer.tf(
        "/tf_static",
        0,
        "robot",
        "laser",
        Transform::planar(0.0, 0.0, 1.0),
    );
    writer.tf("/tf", S, "map", "odom", Transform::planar(7.0, 0.0, 0.0));
    writer.tf("/tf", 2 * S, "map", "odom", Transform::planar(9.0, 0.0, 0.0));
    writer.tf("/tf", S, "odom", "robot", Transform::planar(1.0, 0.0, 0.0));
    writer.tf("/tf", 2 * S, "odom", "robot", Transform::planar(3.0, 0.0, 0.0));
    for tenths in 10..=20 {
        writer.scan(&scan_at(tenths * TENTH));
    }
    writer.finish();
    for odom in ["odom", "/map"] {
        let out = dir
            .join(odom.trim_start_matches('/'))
            .to_str()
            .unwrap()
            .to_owned();
        let frames = [
            "--odom-frame",
            odom,
            "--base-frame",
            "robot",
            "--width",
            "40",
            "--height",
            "40",
        ];
        json(
            &[&["replay", &log, "--json", "--out", &out], &frames[..]].concat(),
            0,
        );
        // Its own output has the same frames, so it can be replayed in the same way.
        let again = format!("{out}/core.mcap");
        let summary = json(&[&["replay", &again, "--json"], &frames[..]].concat(), 0);
        assert_eq!(
            (&summary["scans"], &summary["skipped_scans"]),
            (&11.into(), &0.into()),
            "{odom}"
        );
    }
    refused(
        &["replay", &log],
        &[
            "in.mcap",
            "none of the 11 scans on /scan",
            "`base_link` is unknown",
        ],
    );
}

#[test]
fn a_truncated_log_is_replayed_as_far_as_it_goes() {
    let (dir, log) = log_in("replay_truncated");
    let out = dir.join("demo");
    let out = out.to_str().unwrap();
    json(&["demo", "--seconds", "3", "--out", out, "--json"], 0);
    let bytes = fs::read(format!("{out}/core.mcap")).unwrap();
    fs::write(&log, &bytes[..bytes.len() * 6 / 10]).unwrap();
    let summary = json(&["replay", &log, "--width", "30", "--height", "30", "--json"], 0);
    let scans = summary["scans"].as_u64().unwrap();
    assert!((1..30).contains(&scans), "{scans}");
    assert!(summary["truncated_at_byte"].as_u64().unwrap() > 0);

    fs::write(&log, &bytes[..200]).unwrap();
    refused(
        &["replay", &log],
        &["in.mcap", "truncated at byte", "sensor_msgs/msg/LaserScan"],
    );
}
