//! `horus-host pub` and `horus-host sub`: a log goes through shared memory.

use std::fs;
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

use horus_host::log::msg::OccupancyGrid;
use horus_host::log::{LogEntry, LogReader};
use horus_host::topic::{Domain, GridHeader, LocalGridHeader, SliceTopic, TopicOptions, frame_bytes, kind};

use crate::support::{TestLog, code, refused, run, scan_at, scratch, stderr};

/// A domain of a test's own, and its name.
struct TestDomain(Domain, String);

impl TestDomain {
    fn new(test: &str) -> Self {
        let name = format!("{test}_{}", std::process::id());
        Self(Domain::new(&name).unwrap(), name)
    }
}

impl Drop for TestDomain {
    fn drop(&mut self) {
        self.0.remove();
    }
}

fn start(arguments: &[&str]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_horus-host"))
        .args(arguments)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

fn finished(child: Child) -> Output {
    let output = child.wait_with_output().unwrap();
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    output
}

#[test]
fn what_is_published_is_recorded() {
    let dir = scratch("bridge");
    let path = |name: &str| dir.join(name).to_str().unwrap().to_owned();
    let out = dir.to_str().unwrap();
    assert_eq!(code(&run(&["demo", "--seconds", "2", "--out", out])), 0);
    let (core, live) = (path("core.mcap"), path("live.mcap"));
    let domain = TestDomain::new("bridge");
    let sub = start(&["sub", "--out", &live, "--domain", &domain.1, "--json"]);
    let sent = finished(start(&[
        "pub", &core, "--wait", "1", "--rate", "0", "--domain", &domain.1, "--json",
    ]));
    let received = finished(sub);
    let counts = |output: &Output| {
        let value: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        (value["messages"].clone(), value["topics"].clone())
    };
    assert_eq!(counts(&sent), counts(&received));
    assert_eq!(counts(&sent).0, 101);
    let comparison = run(&["compare", &core, &live]);
    assert_eq!(
        code(&comparison),
        0,
        "{}",
        String::from_utf8_lossy(&comparison.stdout)
    );
}

#[test]
fn limits_topics_and_silence_end_a_recording() {
    let dir = scratch("bridge_limits");
    let path = |name: &str| dir.join(name).to_str().unwrap().to_owned();
    let (log, live) = (path("log.mcap"), path("live.mcap"));
    let mut writer = TestLog::with_mount(log.as_ref());
    for second in 1..=20 {
        writer.robot(second * 1_000_000_000);
        writer.scan(&scan_at(second * 1_000_000_000));
    }
    writer.finish();
    let domain = TestDomain::new("limits");
    let common = ["--domain", &domain.1];
    let sub = start(
        &[
            &[
                "sub", "--out", &live, "--topic", "/scan", "--limit", "5", "--json",
            ],
            &common[..],
        ]
        .concat(),
    );
    let published = run(&[
        &["pub", &log, "--topic", "/scan", "--wait", "1", "--rate", "10"],
        &common[..],
    ]
    .concat());
    assert_eq!(code(&published), 0, "{}", stderr(&published));
    let received: serde_json::Value = serde_json::from_slice(&finished(sub).stdout).unwrap();
    assert_eq!(received["topics"], serde_json::json!({"/scan": 5}));

    let kept = path("kept.mcap");
    fs::copy(&log, &kept).unwrap();
    let silent = [&["sub", "--out", &kept, "--timeout", "1"], &common[..]].concat();
    refused(&silent, &["no message came"]);
    assert_eq!(
        fs::read(&kept).unwrap(),
        fs::read(&log).unwrap(),
        "a log that was there stays"
    );
    let none = path("none.mcap");
    let silent = [&["sub", "--out", &none, "--timeout", "1"], &common[..]].concat();
    refused(&silent, &["no message came"]);
    assert!(!fs::exists(&none).unwrap(), "nothing is left");
    refused(
        &[&["pub", &log, "--wait", "1", "--patience", "1"], &common[..]].concat(),
        &["0 of 1 subscribers"],
    );
    refused(
        &[&["pub", &log, "--topic", "/none"], &common[..]].concat(),
        &["no topic /none"],
    );
    refused(
        &[&["pub", &log, "--rate", "-1"], &common[..]].concat(),
        &["zero or more"],
    );
    refused(&["pub", &log, "--domain", "a b"], &["domain"]);
    refused(
        &["sub", "--out", &path("no/such.mcap")],
        &["cannot create the log"],
    );
    assert_eq!(code(&run(&["sub"])), 2);
}

#[test]
fn a_local_map_is_recorded_as_occupancy() {
    let dir = scratch("bridge_local");
    let live = dir.join("live.mcap");
    let domain = TestDomain::new("local_map");
    let header = LocalGridHeader {
        grid: GridHeader {
            timestamp_ns: 7,
            resolution: 0.1,
            width: 4,
            height: 1,
            frame_id: frame_bytes("odom"),
            ..GridHeader::default()
        },
    };
    let maps = SliceTopic::<kind::Local>::open(&domain.0, "local_grid_map", TopicOptions::default()).unwrap();
    let out = live.to_str().unwrap();
    let sub = start(&["sub", "--out", out, "--limit", "1", "--domain", &domain.1]);
    maps.wait_for_subscribers(1, Duration::from_secs(30)).unwrap();
    maps.send(header, &[0, 128, 255, 77]).unwrap();
    finished(sub);
    let mut log = LogReader::open(&live).unwrap().map(Result::unwrap);
    let map: OccupancyGrid = log
        .find_map(|entry| match entry {
            LogEntry::Message(message) => Some(message.decode().unwrap()),
            _ => None,
        })
        .unwrap();
    assert_eq!(map.data, [100, -1, 0, -1]);
    assert_eq!((map.info.width, &map.header.frame_id[..]), (4, "odom"));
}
