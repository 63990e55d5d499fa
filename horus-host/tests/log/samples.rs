//! A small log with every message type, for the tests of the log module.
#![allow(dead_code, reason = "each test program uses its own part")]
use std::{collections::BTreeMap, io::Write, path::PathBuf};

use horus_host::log::{
    LogEntry, LogError, LogReader, LogWriter, ReadEnd, cost_to_viewable,
    msg::{
        Costmap, CostmapMetaData, Grid, Header, LaserScan, MapMetaData, NumericType, OccupancyGrid,
        PackedElementField, Path, Pose, PoseStamped, TFMessage, Time, Transform, TransformStamped, Vector2,
    },
};

pub const WIDTH: u32 = 7;
pub const HEIGHT: u32 = 5;
pub const RESOLUTION: f32 = 0.05;

/// Stamp of tick `tick`, ns.
pub fn stamp(tick: u64) -> u64 {
    1_700_000_000_000_000_000 + tick * 100_000_000
}

fn cell(tick: u64, index: u32) -> u8 {
    (tick * 31 + u64::from(index) * 37) as u8
}

pub fn costs(tick: u64) -> Vec<u8> {
    (0..WIDTH * HEIGHT).map(|index| cell(tick, index)).collect()
}

pub fn occupancy(tick: u64) -> OccupancyGrid {
    OccupancyGrid {
        header: Header::new(stamp(tick), "map"),
        info: MapMetaData {
            map_load_time: Time::from_ns(stamp(0)),
            resolution: RESOLUTION,
            width: WIDTH,
            height: HEIGHT,
            origin: Pose::planar(-1.0, 2.5, 0.25),
        },
        data: costs(tick)
            .iter()
            .map(|cost| cost_to_viewable(*cost, 253))
            .collect(),
    }
}

pub fn costmap(tick: u64) -> Costmap {
    Costmap {
        header: Header::new(stamp(tick), "map"),
        metadata: CostmapMetaData {
            map_load_time: Time::from_ns(stamp(0)),
            update_time: Time::from_ns(stamp(tick)),
            layer: "master".to_owned(),
            resolution: RESOLUTION,
            size_x: WIDTH,
            size_y: HEIGHT,
            origin: Pose::planar(-1.0, 2.5, 0.25),
        },
        data: costs(tick),
    }
}

pub fn evidence(tick: u64) -> Grid {
    let masses = ["free", "occupied", "unknown"];
    let colours = ["red", "green", "blue", "alpha"];
    let mass_fields = (0..).step_by(4).zip(masses);
    let colour_fields = (12..).zip(colours);
    let mass = |offset, name| PackedElementField::new(name, offset, NumericType::Float32);
    let colour = |offset, name| PackedElementField::new(name, offset, NumericType::Uint8);
    Grid {
        timestamp: Time::from_ns(stamp(tick)),
        frame_id: "odom".to_owned(),
        pose: Pose::planar(0.5, -0.5, 0.0),
        column_count: WIDTH,
        cell_size: Vector2 { x: 0.05, y: 0.05 },
        row_stride: 16 * WIDTH,
        cell_stride: 16,
        fields: mass_fields
            .map(|(offset, name)| mass(offset, name))
            .chain(colour_fields.map(|(offset, name)| colour(offset, name)))
            .collect(),
        data: (0..WIDTH * HEIGHT)
            .flat_map(|index| {
                let occupied = f32::from(cell(tick, index)) / 255.0;
                let masses = [0.5 * (1.0 - occupied), occupied, 0.5 * (1.0 - occupied)];
                let mut bytes: Vec<u8> = masses.iter().flat_map(|m| m.to_le_bytes()).collect();
                bytes.extend([cell(tick, index), 1, 2, 255]);
                bytes
            })
            .collect(),
    }
}

pub fn scan(tick: u64) -> LaserScan {
    LaserScan {
        header: Header::new(stamp(tick), "laser"),
        angle_min: -1.5,
        angle_max: 1.5,
        angle_increment: 0.75,
        time_increment: 0.001,
        scan_time: 0.1,
        range_min: 0.05,
        range_max: 30.0,
        ranges: vec![1.0, f32::INFINITY, 2.5 + tick as f32, f32::NEG_INFINITY, 29.0],
        intensities: vec![10.0, 0.0, 20.5, 0.0, 7.0],
    }
}

pub fn transforms(tick: u64) -> TFMessage {
    let edge = |parent, child: &str, x| TransformStamped {
        header: Header::new(stamp(tick), parent),
        child_frame_id: child.to_owned(),
        transform: Transform::planar(x, 0.5, 0.1 * tick as f64),
    };
    TFMessage {
        transforms: vec![edge("map", "odom", 0.25), edge("odom", "base_link", tick as f64)],
    }
}

pub fn path(tick: u64) -> Path {
    let pose = |step| PoseStamped {
        header: Header::new(stamp(tick), "map"),
        pose: Pose::planar(0.1 * f64::from(step), 1.0, 0.0),
    };
    Path {
        header: Header::new(stamp(tick), "map"),
        poses: (0..3).map(pose).collect(),
    }
}

pub fn metadata() -> BTreeMap<String, String> {
    let pair = |key: &str, value: &str| (key.to_owned(), value.to_owned());
    BTreeMap::from([pair("version", "0.1.0"), pair("resolution", "0.05")])
}

/// Messages of one tick: one on every topic.
pub const TOPICS: usize = 7;

pub fn write_tick<W: Write>(log: &mut LogWriter<W>, tick: u64) -> Result<(), LogError> {
    let stamp = stamp(tick);
    log.write("/tf", stamp, &transforms(tick))?;
    log.write("/scan", stamp, &scan(tick))?;
    log.write("/map", stamp, &occupancy(tick))?;
    log.write("/costmap_raw", stamp, &costmap(tick))?;
    log.write("/evidence", stamp, &evidence(tick))?;
    log.write("/plan", stamp, &path(tick))?;
    log.write("/tf_static", stamp, &transforms(tick))
}

/// A finished log of `ticks` ticks, flushed after each.
pub fn sample(ticks: u64) -> Vec<u8> {
    let mut log = LogWriter::new(Vec::new()).unwrap();
    log.metadata("horus", metadata()).unwrap();
    for tick in 0..ticks {
        write_tick(&mut log, tick).unwrap();
        log.flush().unwrap();
    }
    log.finish().unwrap()
}

/// Everything that can be read from `bytes`, and how it ended.
pub fn read(bytes: &[u8]) -> (Vec<LogEntry>, Result<ReadEnd, LogError>) {
    let mut reader = LogReader::new(bytes);
    let mut entries = Vec::new();
    for entry in &mut reader {
        match entry {
            Ok(entry) => entries.push(entry),
            Err(error) => return (entries, Err(error)),
        }
    }
    (entries, Ok(reader.end().unwrap()))
}

/// A path for a file of this test run.
pub fn scratch(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("log");
    std::fs::create_dir_all(&folder).unwrap();
    folder.join(name)
}
