//! `horus-host record`: a stream of frames becomes the log that a run on the host writes.

mod cli_support;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::{Read, Write};
use std::path::Path;
use std::process::{Child, Command, Stdio};

use cli_support::{code, json, refused, run, scratch, stderr};
use horus_core::costmap::{CostMapBuffers, bit_words};
use horus_core::frames::{MapStream, StreamOptions, StreamTick};
use horus_core::prelude::*;
use horus_host::log::{LogEntry, LogReader, ReadEnd};
use horus_host::sim::{Lidar, SimConfig, Simulation};

const SIDE: u32 = 100;
const SIZE: [&str; 4] = ["--width", "100", "--height", "100"];
const BEAMS: usize = 90;

/// A drive through the simulated building as a target streams it, with some text before each tick.
fn stream(ticks: u32) -> Vec<u8> {
    let mount = Pose2D::new(0.1, 0.0, 0.0);
    let config = SimConfig {
        ticks,
        lidar: Lidar {
            beams: BEAMS,
            angle_increment: std::f32::consts::TAU / BEAMS as f32,
            ..Lidar::default()
        },
        ..SimConfig::default()
    };
    let lidar = config.lidar.clone();
    let mut storage = Box::new(CostMapBuffers::<
        { (SIDE * SIDE) as usize },
        { bit_words(SIDE, SIDE) },
    >::empty());
    let mut beams = ScanBuffers::<BEAMS, 0>::empty();
    let (cells, buffers) = storage.split();
    let half = -(SIDE as f32 * 0.05) * 0.5;
    let grid = OccupancyGrid::new_in(cells, SIDE, SIDE, 0.05, Pose2D::new(half, half, 0.0)).unwrap();
    let mut map = CostMap::new_in(grid, buffers, CostParams::default()).unwrap();
    let mut workspace = beams.workspace();
    let mut wire = Vec::new();
    let mut buffer = [0; 1024];
    let options = StreamOptions {
        mount,
        key_every: 8,
        checksum_every: 3,
        ..StreamOptions::default()
    };
    let sink = |frame: &[u8]| wire.extend_from_slice(frame);
    let mut stream = MapStream::new_in(&mut buffer, sink, options).unwrap();
    for tick in Simulation::new(config) {
        let (sin, cos) = tick.robot.theta.sin_cos();
        let heading = sin.atan2(cos);
        let pose = |x: f64, y: f64| Pose2D::new(x as f32, y as f32, heading as f32);
        let robot = pose(tick.robot.x, tick.robot.y);
        // From the robot's pose as it is sent, so that the log's transforms give the same.
        let (x, y) = (f64::from(robot.x), f64::from(robot.y));
        let (sin, cos) = f64::from(robot.theta).sin_cos();
        let ahead = f64::from(mount.x);
        let sensor = pose(x + cos * ahead, y + sin * ahead);
        let scan = LaserScan {
            angle_min: lidar.angle_min,
            angle_increment: lidar.angle_increment,
            range_min: lidar.range_min,
            range_max: lidar.range_max,
            ranges: &tick.ranges,
        };
        map.recenter(robot).unwrap();
        let report = map
            .integrate_scan(&scan, sensor, ScanModel::Set, &mut workspace)
            .unwrap();
        let costs_changed = map.update_costs();
        let stamp_ns = tick.stamp_ns;
        let tick = StreamTick {
            stamp_ns,
            robot,
            sensor,
            scan,
            changed: report.changed,
            costs_changed,
        };
        stream.tick(&map, &tick);
        stream.sink_mut()(b"a line of text\r\n");
    }
    wire
}

/// Every message of a whole log: topic, time, payload.
fn messages(path: &Path) -> Vec<(String, u64, Vec<u8>)> {
    let mut reader = LogReader::open(path).unwrap();
    let mut messages = Vec::new();
    for entry in &mut reader {
        if let LogEntry::Message(message) = entry.unwrap() {
            messages.push((message.topic().to_owned(), message.log_time_ns, message.payload));
        }
    }
    assert_eq!(reader.end(), Some(ReadEnd::Complete));
    messages
}

struct Files {
    wire: Vec<u8>,
    stream: String,
    log: String,
    out: String,
}

fn files(test: &str, ticks: u32) -> Files {
    let dir = scratch(test);
    let path = |name: &str| dir.join(name).to_str().unwrap().to_owned();
    let files = Files {
        wire: stream(ticks),
        stream: path("stream.bin"),
        log: path("target.mcap"),
        out: path("out"),
    };
    fs::write(&files.stream, &files.wire).unwrap();
    files
}

#[test]
fn the_log_of_the_target_is_the_log_of_the_host() {
    let files = files("record_whole", 20);
    let summary = json(&["record", &files.stream, "--out", &files.log, "--json"], 0);
    assert_eq!(
        (&summary["ticks"], &summary["skipped_ticks"]),
        (&20.into(), &0.into())
    );
    assert_eq!(summary["bytes"], files.wire.len());
    assert_eq!(summary["bytes_outside_frames"], 20 * 16, "the text");
    assert_eq!(summary["problems"], serde_json::json!({}));

    let topics: BTreeSet<String> = messages(Path::new(&files.log))
        .into_iter()
        .map(|message| message.0)
        .collect();
    let expected = [
        "/costmap",
        "/costmap_raw",
        "/local_map",
        "/scan",
        "/tf",
        "/tf_static",
    ];
    assert_eq!(topics.iter().map(String::as_str).collect::<Vec<_>>(), expected);
    let mut reader = LogReader::open(Path::new(&files.log)).unwrap();
    let Some(Ok(LogEntry::Metadata { name, values })) = reader.next() else {
        panic!("metadata comes first");
    };
    let value = |key: &str| values[key].as_str();
    assert_eq!(
        (name.as_str(), value("side"), value("width")),
        ("horus", "target", "100")
    );
    assert_eq!((value("decay"), value("lethal_cost")), ("polynomial", "253"));

    // The host's own run over the target's scans and poses.
    json(
        &[&["replay", &files.log, "--out", &files.out, "--json"], &SIZE[..]].concat(),
        0,
    );
    for side in ["core", "std"] {
        let host = format!("{}/{side}.mcap", files.out);
        let comparison = json(&["compare", &files.log, &host, "--json"], 0);
        assert_eq!(comparison["equal"], true, "{comparison}");
        assert_eq!(comparison["topics"].as_array().unwrap().len(), 6);
    }
    // Other parameters on the host are noticed.
    json(
        &[
            &[
                "replay",
                &files.log,
                "--out",
                &files.out,
                "--scaling",
                "5",
                "--json",
            ],
            &SIZE[..],
        ]
        .concat(),
        0,
    );
    json(
        &[
            "compare",
            &files.log,
            &format!("{}/core.mcap", files.out),
            "--json",
        ],
        1,
    );
}

#[test]
fn a_replay_of_a_replay_writes_the_same_log() {
    let files = files("record_again", 6);
    json(&["record", &files.stream, "--out", &files.log, "--json"], 0);
    json(
        &[&["replay", &files.log, "--out", &files.out, "--json"], &SIZE[..]].concat(),
        0,
    );
    let (once, twice) = (format!("{}/core.mcap", files.out), format!("{}2", files.out));
    json(
        &[&["replay", &once, "--out", &twice, "--json"], &SIZE[..]].concat(),
        0,
    );
    json(&["compare", &once, &format!("{twice}/core.mcap"), "--json"], 0);
}

#[test]
fn damage_is_told_and_skipped_and_the_log_stays_good() {
    let files = files("record_damaged", 24);
    json(&["record", &files.stream, "--out", &files.log, "--json"], 0);
    let good: BTreeMap<(String, u64), Vec<u8>> = messages(Path::new(&files.log))
        .into_iter()
        .map(|(topic, stamp, payload)| ((topic, stamp), payload))
        .collect();
    let mut random = 0x9e37_79b9_7f4a_7c15u64;
    let mut below = |n: usize| {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        (random >> 11) as usize % n
    };
    let damaged_log = format!("{}.damaged", files.log);
    let mut lossy = 0;
    for round in 0..40 {
        let mut wire = files.wire.clone();
        let at = below(wire.len());
        let end = (at + 1 + below(3000)).min(wire.len());
        match round % 5 {
            0 => wire[at] ^= 1 << below(8),
            1 => drop(wire.drain(at..end)),
            2 => wire[at..end].reverse(),
            3 => {
                let part = wire[at..end].to_vec();
                drop(wire.splice(at..at, part));
            }
            _ => wire.truncate(at),
        }
        fs::write(&files.stream, &wire).unwrap();
        let output = run(&["record", &files.stream, "--out", &damaged_log, "--json"]);
        match code(&output) {
            2 => {
                assert!(stderr(&output).contains("no whole tick"), "{}", stderr(&output));
                continue;
            }
            1 => lossy += 1,
            // Only the text between frames can be damaged without a loss.
            code => assert_eq!(code, 0),
        }
        for (topic, stamp, payload) in messages(Path::new(&damaged_log)) {
            if topic == "/tf_static" {
                continue; // written with the first tick there is, at its time
            }
            assert_eq!(
                good.get(&(topic.clone(), stamp)),
                Some(&payload),
                "{topic} at {stamp}, round {round}"
            );
        }
    }
    assert!(lossy > 20, "{lossy} lossy");
}

#[test]
fn problems_are_told_in_plain_sentences() {
    let files = files("record_sentences", 12);
    let mut wire = files.wire.clone();
    let middle = wire.len() / 2;
    wire[middle] ^= 1;
    wire.truncate(wire.len() - 40);
    fs::write(&files.stream, &wire).unwrap();
    let output = run(&["record", &files.stream, "--out", &files.log]);
    assert_eq!(code(&output), 1, "{}", stderr(&output));
    let text = String::from_utf8(output.stdout).unwrap();
    for words in [
        "damaged in 1 place (first at byte",
        "ends in the middle of a tick",
        "never came",
        "skipped",
    ] {
        assert!(text.contains(words), "{text}");
    }
}

#[test]
fn standard_input_and_a_limit() {
    let files = files("record_stdin", 12);
    let mut child = start(&["record", "-", "--out", &files.log, "--limit", "5", "--json"]);
    let mut input = child.stdin.take().unwrap();
    input.write_all(&files.wire).unwrap(); // less than the pipe and the reader hold
    // Standard input stays open: the limit ends it.
    assert_eq!(finished(child)["ticks"], 5);
    drop(input);
    assert_eq!(
        messages(Path::new(&files.log))
            .iter()
            .filter(|message| message.0 == "/scan")
            .count(),
        5
    );
}

fn start(arguments: &[&str]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_horus-host"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// The JSON of a child that ends well.
fn finished(child: Child) -> serde_json::Value {
    let output = child.wait_with_output().unwrap();
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// Waits until a file is there and has grown longer than so many bytes.
#[cfg(unix)]
fn wait_for(path: &Path, bytes: u64) {
    for _ in 0..600 {
        if fs::metadata(path).is_ok_and(|file| file.len() >= bytes) {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
    panic!("{} does not grow", path.display());
}

#[cfg(unix)]
#[test]
fn a_serial_device_until_ctrl_c() {
    use serialport::{SerialPort, TTYPort};
    let files = files("record_device", 12);
    let (mut target, host) = TTYPort::pair().unwrap();
    let device = host.name().unwrap();
    let child = start(&[
        "record", &device, "--baud", "921600", "--out", &files.log, "--json",
    ]);
    wait_for(Path::new(&files.log), 0); // made once the device is open
    // Zeros, flow control characters and line ends must pass a raw line unchanged.
    let booting = b"\0\x11\x13\r\nbooting\n\x04\x03";
    target.write_all(booting).unwrap();
    for part in files.wire.chunks(512) {
        target.write_all(part).unwrap();
        std::thread::sleep(std::time::Duration::from_millis(1)); // a line has a speed
    }
    wait_for(Path::new(&files.log), 100);
    std::thread::sleep(std::time::Duration::from_millis(500));
    let id = child.id().to_string();
    assert!(
        Command::new("kill")
            .args(["-INT", &id])
            .status()
            .unwrap()
            .success()
    );
    let summary = finished(child);
    assert_eq!(
        (&summary["ticks"], &summary["problems"]),
        (&12.into(), &serde_json::json!({})),
        "{summary}"
    );
    assert_eq!(summary["bytes"], files.wire.len() + booting.len());
    drop((target, host));

    let from_device = messages(Path::new(&files.log));
    json(&["record", &files.stream, "--out", &files.log, "--json"], 0);
    assert!(
        from_device == messages(Path::new(&files.log)),
        "the same log as from a file"
    );
}

#[cfg(unix)]
#[test]
fn a_killed_recording_leaves_what_was_flushed() {
    let files = files("record_killed", 80);
    let mut child = start(&["record", "-", "--out", &files.log]);
    let mut input = child.stdin.take().unwrap();
    input.write_all(&files.wire).unwrap();
    wait_for(Path::new(&files.log), 100);
    std::thread::sleep(std::time::Duration::from_millis(1500));
    child.kill().unwrap();
    child.wait().unwrap();
    let mut reader = LogReader::open(Path::new(&files.log)).unwrap();
    let scans = (&mut reader)
        .filter(|entry| matches!(entry, Ok(LogEntry::Message(message)) if message.topic() == "/scan"))
        .count();
    assert!(scans >= 64, "{scans} scans");
    assert!(matches!(reader.end(), Some(ReadEnd::Truncated { .. })));
}

#[test]
fn what_cannot_be_recorded() {
    let files = files("record_bad", 2);
    let dir = scratch("record_bad_files");
    let path = |name: &str| dir.join(name).to_str().unwrap().to_owned();
    let (log, text) = (path("log.mcap"), path("text.txt"));
    fs::write(&text, "no frames here\n").unwrap();
    refused(
        &["record", &path("missing.bin"), "--out", &log],
        &["cannot open", "missing.bin"],
    );
    refused(
        &["record", &text, "--out", &log],
        &["text.txt", "no whole tick in 15 bytes and 0 frames"],
    );
    assert!(!Path::new(&log).exists(), "nothing is left");
    refused(
        &["record", dir.to_str().unwrap(), "--out", &log],
        &["record_bad_files"],
    );
    assert!(!Path::new(&log).exists(), "nothing is left");
    refused(
        &["record", "/dev/null", "--out", &log],
        &["/dev/null", "no whole tick in 0 bytes"],
    );
    refused(
        &["record", &files.stream, "--out", &files.stream],
        &["stream.bin", "overwritten"],
    );
    refused(
        &["record", &files.stream, "--out", &path("no/such/dir.mcap")],
        &["cannot write the log", "dir.mcap"],
    );
    refused(
        &["record", &files.stream, "--out", dir.to_str().unwrap()],
        &["cannot write the log"],
    );
    // The stream after its first key tick: nothing to start from, and an older log stays.
    fs::write(&log, "an older log").unwrap();
    let late = path("late.bin");
    let mut wire = Vec::new();
    fs::File::open(&files.stream)
        .unwrap()
        .read_to_end(&mut wire)
        .unwrap();
    fs::write(&late, &wire[wire.len() - 500..]).unwrap();
    refused(
        &["record", &late, "--out", &log],
        &["late.bin", "the beginning of the stream is missing"],
    );
    assert_eq!(fs::read_to_string(&log).unwrap(), "an older log");
    for arguments in [
        &["record"][..],
        &["record", "x"],
        &["record", "x", "--out", "y", "--baud", "0"],
    ] {
        assert_eq!(code(&run(arguments)), 2, "{arguments:?}");
    }
}
