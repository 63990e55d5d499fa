//! Streams to record.

use std::fs;
use std::path::Path;

use horus_core::costmap::{CostMapBuffers, bit_words};
use horus_core::frames::{MapStream, StreamOptions, StreamTick};
use horus_core::prelude::*;
use horus_host::log::{LogEntry, LogReader, ReadEnd};
use horus_host::sim::{Lidar, SimConfig, Simulation};

use crate::support::scratch;

const SIDE: u32 = 100;
pub const SIZE: [&str; 4] = ["--width", "100", "--height", "100"];
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
pub fn messages(path: &Path) -> Vec<(String, u64, Vec<u8>)> {
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

pub struct Files {
    pub wire: Vec<u8>,
    pub stream: String,
    pub log: String,
    pub out: String,
}

pub fn files(test: &str, ticks: u32) -> Files {
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
