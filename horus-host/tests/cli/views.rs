//! `horus-host info` and `horus-host render`.

use std::fs;

use crate::support::{Painted, S, TestLog, code, json, refused, run, scan_at, scratch};

/// A short demo; its directory.
fn demo(test: &str) -> String {
    let dir = scratch(test);
    let path = dir.to_str().unwrap().to_owned();
    let size = ["--width", "60", "--height", "40"];
    let arguments = [&["demo", "--seconds", "1", "--out", &path], &size[..]].concat();
    assert_eq!(code(&run(&arguments)), 0);
    path
}

#[test]
fn info_tells_what_is_in_a_log() {
    let dir = demo("info");
    let info = json(&["info", &format!("{dir}/core.mcap"), "--json"], 0);
    assert_eq!(
        (&info["messages"], &info["duration_s"]),
        (&51.into(), &0.9.into())
    );
    assert_eq!(info["truncated_at_byte"], serde_json::Value::Null);
    let topics = info["topics"].as_array().unwrap();
    let topic = |name: &str| topics.iter().find(|topic| topic["topic"] == name).unwrap();
    assert_eq!(topics.len(), 6);
    let map = topic("/local_map");
    assert_eq!(
        (&map["messages"], &map["type"]),
        (&10.into(), &"nav_msgs/msg/OccupancyGrid".into())
    );
    assert!((map["rate_hz"].as_f64().unwrap() - 10.0).abs() < 1e-9);
    assert_eq!(
        (&map["grid"]["width"], &map["grid"]["height"]),
        (&60.into(), &40.into())
    );
    assert_eq!(map["grid"]["frame"], "odom");
    assert_eq!(topic("/scan")["beams"], 360);
    assert_eq!(topic("/tf_static")["rate_hz"], serde_json::Value::Null);
    let metadata = &info["metadata"][0];
    assert_eq!(
        (&metadata["name"], &metadata["values"]["side"]),
        (&"horus".into(), &"core".into())
    );
    let text = String::from_utf8(run(&["info", &format!("{dir}/core.mcap")]).stdout).unwrap();
    assert!(text.contains("60 x 40 cells of 0.05 m"), "{text}");

    // Cut in the middle: told, and no error.
    let bytes = fs::read(format!("{dir}/core.mcap")).unwrap();
    let cut = format!("{dir}/cut.mcap");
    fs::write(&cut, &bytes[..bytes.len() / 2]).unwrap();
    assert!(json(&["info", &cut, "--json"], 0)["truncated_at_byte"].is_u64());
    refused(&["info", &format!("{dir}/none.mcap")], &["none.mcap"]);
    refused(&["info", &format!("{dir}/costmap.png")], &["not an MCAP file"]);
    assert_eq!(code(&run(&["info"])), 2);
}

#[test]
fn frames_show_grid_robot_and_scale() {
    let dir = demo("render");
    let (core, std, out) = (
        format!("{dir}/core.mcap"),
        format!("{dir}/std.mcap"),
        format!("{dir}/f"),
    );
    let rendered = json(
        &[
            "render", &core, "--out", &out, "--every", "4", "--scale", "5", "--json",
        ],
        0,
    );
    assert_eq!(
        (&rendered["topic"], &rendered["messages"], &rendered["frames"]),
        (&"/costmap".into(), &10.into(), &3.into())
    );
    let frame = Painted::read(format!("{out}/costmap_000008.png"));
    assert_eq!(frame.size(), (300, 224));
    let count =
        |frame: &Painted, colour: [u8; 4]| frame.pixels.iter().filter(|pixel| **pixel == colour).count();
    assert!(count(&frame, [255, 255, 255, 0]) > 1000, "cost 0 is transparent");
    assert!(count(&frame, [0, 0xa0, 0x40, 255]) > 100, "the robot");
    assert!(
        count(&frame, [255, 0, 255, 255]) > 100,
        "lethal cells are magenta"
    );

    let beside = [
        &["render", &core, "--out", &out, "--against", &std, "--at", "0.5"],
        &["--topic", "/local_map", "--scale", "5", "--json"][..],
    ]
    .concat();
    let rendered = json(&beside, 0);
    assert_eq!(rendered["frames"], 1);
    let frame = Painted::read(format!("{out}/local_map_000005.png"));
    assert_eq!(frame.size(), (3 * 300 + 2 * 8, 224));
    let equal = (616..916).all(|x| (0..200).all(|y| frame.at(x, y) == [0xc8; 3]));
    assert!(equal, "the difference is grey all over");
    assert!(count(&frame, [0xe0, 0x40, 0, 255]) > 20, "ends of beams");
    let plain = [&beside[..], &["--no-overlay"]].concat();
    json(&plain, 0);
    let frame = Painted::read(format!("{out}/local_map_000005.png"));
    assert_eq!(count(&frame, [0, 0xa0, 0x40, 255]), 0);

    // Before the first grid nothing is painted; distances and evidence come with other logs.
    refused(
        &["render", &core, "--out", &out, "--topic", "/scan"],
        &["/scan", "/costmap, /costmap_raw, /local_map"],
    );
    refused(&["render", &core, "--out", &out, "--at", "-1"], &["zero or more"]);
    refused(&["render", &format!("{dir}/none.mcap")], &["none.mcap"]);
    refused(
        &["render", &core, "--out", &format!("{dir}/core.mcap")],
        &["core.mcap"],
    );
    refused(
        &[
            "render",
            &core,
            "--out",
            &out,
            "--against",
            &format!("{dir}/none.mcap"),
        ],
        &["none.mcap"],
    );
    let scans = format!("{dir}/scans.mcap");
    let mut log = TestLog::with_mount(scans.as_ref());
    log.scan(&scan_at(S));
    log.finish();
    refused(&["render", &scans, "--out", &out], &["holds no grids"]);
    for wrong in ["--every", "--scale"] {
        assert_eq!(code(&run(&["render", &core, wrong, "0"])), 2);
    }
}

#[test]
fn the_foxglove_layout_shows_what_the_logs_hold() {
    let text = include_str!("../../docs/foxglove-layout.json");
    let layout: serde_json::Value = serde_json::from_str(text).unwrap();
    let panels = layout["configById"].as_object().unwrap();
    for topic in [
        "/map",
        "/local_map",
        "/costmap",
        "/evidence",
        "/distance",
        "/scan",
        "/plan",
    ] {
        let shown = panels
            .values()
            .any(|panel| panel["topics"][topic]["visible"] == true);
        assert!(shown, "{topic} is hidden");
    }
    // Every panel stands somewhere in the layout.
    let places = layout["layout"].to_string();
    assert!(panels.keys().all(|panel| places.contains(panel)));
}
