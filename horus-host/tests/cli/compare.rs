//! `horus-host compare`: equal, different, unreadable.

use std::fs;

use crate::support::{Painted, S, TestLog, code, json, refused, run, scan_at, scratch};

#[test]
fn one_changed_range_is_found_and_named() {
    let dir = scratch("compare_pair");
    let path = |name: &str| dir.join(name).to_str().unwrap().to_owned();
    for (name, range) in [("a.mcap", 1.0), ("b.mcap", 1.0), ("c.mcap", 1.5)] {
        let mut log = TestLog::with_mount(&dir.join(name));
        for second in 1..=3 {
            let mut scan = scan_at(second * S);
            if second == 2 {
                scan.ranges[17] = range;
            }
            log.scan(&scan);
        }
        log.finish();
    }
    assert_eq!(
        json(&["compare", &path("a.mcap"), &path("b.mcap"), "--json"], 0)["equal"],
        true
    );
    let different = json(&["compare", &path("a.mcap"), &path("c.mcap"), "--json"], 1);
    assert_eq!(different["equal"], false);

    let output = run(&["compare", &path("a.mcap"), &path("c.mcap")]);
    assert_eq!(code(&output), 1);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(
        text.contains("first difference on /scan: message 1 at 2000000000 ns: ranges[17]"),
        "{text}"
    );
    assert!(text.ends_with("different\n"), "{text}");
}

#[test]
fn a_truncated_log_differs_and_says_so() {
    let dir = scratch("compare_truncated");
    let (whole, part) = (dir.join("whole.mcap"), dir.join("part.mcap"));
    let mut log = TestLog::with_mount(&whole);
    log.scan(&scan_at(S));
    log.finish();
    let bytes = fs::read(&whole).unwrap();
    fs::write(&part, &bytes[..bytes.len() - 20]).unwrap();
    let output = run(&["compare", whole.to_str().unwrap(), part.to_str().unwrap()]);
    assert_eq!(code(&output), 1);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(
        text.contains("the second log is truncated: it was read up to byte"),
        "{text}"
    );
}

#[test]
fn an_unreadable_log_is_named() {
    let dir = scratch("compare_unreadable");
    let (good, bad) = (dir.join("good.mcap"), dir.join("bad.mcap"));
    let mut log = TestLog::create(&good);
    log.scan(&scan_at(S));
    log.finish();
    fs::write(&bad, "no log at all").unwrap();
    let (good, bad) = (good.to_str().unwrap(), bad.to_str().unwrap());
    refused(&["compare", good, bad], &[bad, "not an MCAP file"]);
    refused(&["compare", "no/such.mcap", good, "--json"], &["no/such.mcap"]);
    assert_eq!(code(&run(&["compare", good])), 2, "one log is not enough");
}

/// A log with one cost map per value: that value in a corner.
fn costs(path: &std::path::Path, values: &[(u8, f32)]) {
    use horus_host::log::LogWriter;
    use horus_host::log::msg::{Costmap, CostmapMetaData, Header, LaserScan};
    let mut log = LogWriter::create(path).unwrap();
    for (stamp_ns, &(value, range)) in (1..).zip(values) {
        let mut data = vec![7; 12];
        data[5] = value;
        let metadata = CostmapMetaData {
            resolution: 0.5,
            size_x: 4,
            size_y: 3,
            ..CostmapMetaData::default()
        };
        let map = Costmap {
            header: Header::new(stamp_ns, "odom"),
            metadata,
            data,
        };
        log.write("/costmap_raw", stamp_ns, &map).unwrap();
        let scan = LaserScan {
            ranges: vec![range],
            ..LaserScan::default()
        };
        log.write("/scan", stamp_ns, &scan).unwrap();
    }
    log.finish().unwrap();
}

#[test]
fn tolerances_hold_for_their_topic_and_for_known_cells() {
    let dir = scratch("compare_tolerance");
    let path = |name: &str| dir.join(name).to_str().unwrap().to_owned();
    costs(path("a.mcap").as_ref(), &[(100, 1.0), (254, 1.0)]);
    costs(path("b.mcap").as_ref(), &[(103, 1.25), (255, 1.0)]);
    let compare = |tolerances: &[&str], code| {
        let mut arguments = vec![
            "compare".to_owned(),
            path("a.mcap"),
            path("b.mcap"),
            "--json".to_owned(),
        ];
        for tolerance in tolerances {
            arguments.extend(["--tolerance".to_owned(), (*tolerance).to_owned()]);
        }
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        let comparison = json(&arguments, code);
        let topics = comparison["topics"].as_array().unwrap().clone();
        topics
            .into_iter()
            .map(|topic| topic["differing_messages"].as_u64().unwrap())
            .collect::<Vec<_>>()
    };
    assert_eq!(compare(&[], 1), [2, 1]);
    assert_eq!(compare(&["/scan=0.25"], 1), [2, 0]);
    assert_eq!(compare(&["/scan=0.24", "/costmap_raw=2"], 1), [2, 1]);
    assert_eq!(
        compare(&["/costmap_raw=3", "/scan=1"], 1),
        [1, 0],
        "unknown is not 254"
    );
    costs(path("b.mcap").as_ref(), &[(103, 1.25), (251, 1.0)]);
    assert_eq!(compare(&["/costmap_raw=3", "/scan=1"], 0), [0, 0]);
    let (a, b) = (&path("a.mcap"), &path("b.mcap"));
    refused(&["compare", a, b, "--tolerance", "/none=1"], &["/none"]);
    refused(
        &[
            "compare",
            a,
            b,
            "--tolerance",
            "/scan=1",
            "--tolerance",
            "/scan=2",
        ],
        &["twice"],
    );
    for wrong in ["/scan", "/scan=x", "/scan=-1", "/scan=inf", "=1"] {
        assert_eq!(code(&run(&["compare", a, b, "--tolerance", wrong])), 2, "{wrong}");
    }
}

#[test]
fn differences_become_a_log_and_a_picture() {
    use horus_host::log::msg::OccupancyGrid;
    use horus_host::log::{LogEntry, LogReader};
    let dir = scratch("compare_differences");
    let path = |name: &str| dir.join(name).to_str().unwrap().to_owned();
    costs(path("a.mcap").as_ref(), &[(100, 1.0), (9, 1.0), (8, 1.0)]);
    costs(path("b.mcap").as_ref(), &[(100, 1.0), (99, 2.0), (8, 1.0)]);
    let (diff, picture) = (path("diff.mcap"), path("first.png"));
    let arguments = [
        "compare",
        &path("a.mcap"),
        &path("b.mcap"),
        "--diff",
        &diff,
        "--picture",
        &picture,
    ];
    assert_eq!(code(&run(&arguments)), 1);
    let mut topics = Vec::new();
    for entry in LogReader::open(diff.as_ref()).unwrap() {
        let LogEntry::Message(message) = entry.unwrap() else {
            continue;
        };
        assert_eq!(message.log_time_ns, 2);
        if message.topic() == "/difference/costmap_raw" {
            let map: OccupancyGrid = message.decode().unwrap();
            assert_eq!((map.info.width, map.info.height), (4, 3));
            assert_eq!(map.data, [0, 0, 0, 0, 0, 100, 0, 0, 0, 0, 0, 0]);
        }
        topics.push(message.topic().to_owned());
    }
    let expected = [
        "/a/costmap_raw",
        "/b/costmap_raw",
        "/difference/costmap_raw",
        "/a/scan",
        "/b/scan",
    ];
    assert_eq!(topics, expected);
    // Three pictures of 16 pixels per cell, 8 pixels apart, over a strip.
    let painted = Painted::read(&picture);
    assert_eq!(painted.size(), (3 * 64 + 2 * 8, 48 + 24));
    assert_eq!(
        painted.at(2 * 72 + 16 + 8, 16 + 8),
        [0x10, 0x30, 0xd0],
        "less in the first"
    );
    assert_eq!(painted.at(2 * 72 + 8, 8), [0xc8; 3]);
    assert_eq!(fs::read_dir(&dir).unwrap().count(), 4, "nothing half-written");

    let a = &path("a.mcap");
    refused(&["compare", a, a, "--diff", a], &["overwritten"]);
    refused(
        &[
            "compare",
            a,
            a,
            "--picture",
            &path("no/such.png"),
            "--diff",
            &path("no/d.mcap"),
        ],
        &["d.mcap"],
    );
}
