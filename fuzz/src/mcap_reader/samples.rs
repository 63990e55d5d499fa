//! Good logs and payloads to be damaged.

use std::collections::BTreeMap;
use std::io::Cursor;
use std::sync::OnceLock;

use horus_host::log::msg::{
    Costmap, Grid, Header, LaserScan, Message, OccupancyGrid, PackedElementField, Path, Pose, PoseStamped,
    TFMessage, Transform, TransformStamped,
};
use horus_host::log::{LogError, LogWriter};
use mcap::{Compression, WriteOptions, records};

/// Types of the payloads.
pub(super) const TYPES: [&str; 6] = [
    OccupancyGrid::TYPE,
    Costmap::TYPE,
    Grid::TYPE,
    LaserScan::TYPE,
    Path::TYPE,
    TFMessage::TYPE,
];

/// A good log.
pub(super) fn log(which: u8) -> &'static [u8] {
    static LOGS: OnceLock<Vec<Vec<u8>>> = OnceLock::new();
    let logs = LOGS.get_or_init(|| {
        let mut logs = vec![ours().expect("writing to memory")];
        for compression in [None, Some(Compression::Lz4), Some(Compression::Zstd)] {
            for checksums in [false, true] {
                logs.push(container(compression, checksums).expect("writing to memory"));
            }
        }
        logs
    });
    &logs[usize::from(which) % logs.len()]
}

/// A good payload of one of [`TYPES`].
pub(super) fn payload(which: u8) -> &'static [u8] {
    static PAYLOADS: OnceLock<Vec<Vec<u8>>> = OnceLock::new();
    let payloads = PAYLOADS.get_or_init(|| {
        let all = [
            occupancy().to_payload(),
            costmap().to_payload(),
            grid().to_payload(),
            scan().to_payload(),
            path().to_payload(),
            transforms().to_payload(),
        ];
        all.map(|payload| payload.expect("it can be encoded")).to_vec()
    });
    &payloads[usize::from(which) % payloads.len()]
}

fn occupancy() -> OccupancyGrid {
    let mut message = OccupancyGrid {
        header: Header::new(5, "map"),
        ..Default::default()
    };
    (message.info.width, message.info.height) = (3, 2);
    message.data = vec![-1, 0, 100, 50, 1, -1];
    message
}

fn costmap() -> Costmap {
    let mut message = Costmap {
        header: Header::new(6, "map"),
        ..Default::default()
    };
    (message.metadata.size_x, message.metadata.size_y) = (2, 2);
    message.data = vec![0, 253, 255, 7];
    message
}

fn grid() -> Grid {
    Grid {
        frame_id: "odom".to_owned(),
        column_count: 1,
        fields: vec![PackedElementField::default(), PackedElementField::default()],
        data: vec![1, 2, 3],
        ..Default::default()
    }
}

fn scan() -> LaserScan {
    LaserScan {
        header: Header::new(7, "laser"),
        range_max: 30.0,
        ranges: vec![1.0, f32::INFINITY, f32::NAN],
        ..Default::default()
    }
}

fn path() -> Path {
    let pose = PoseStamped {
        header: Header::new(8, "map"),
        pose: Pose::planar(1.0, 2.0, 0.5),
    };
    Path {
        header: Header::new(8, "map"),
        poses: vec![pose.clone(), pose],
    }
}

fn transforms() -> TFMessage {
    let edge = TransformStamped {
        header: Header::new(9, "map"),
        child_frame_id: "odom".to_owned(),
        transform: Transform::planar(1.0, 0.5, 0.1),
    };
    TFMessage {
        transforms: vec![edge.clone(), edge],
    }
}

/// A log of our own writer.
fn ours() -> Result<Vec<u8>, LogError> {
    let mut log = LogWriter::new(Vec::new())?;
    log.metadata("horus", BTreeMap::from([("version".to_owned(), "1".to_owned())]))?;
    for stamp in 0..2 {
        log.write("/map", stamp, &occupancy())?;
        log.write("/scan", stamp, &scan())?;
        log.write("/tf", stamp, &transforms())?;
        log.flush()?;
    }
    log.finish()
}

/// A log with many small chunks.
fn container(compression: Option<Compression>, checksums: bool) -> mcap::McapResult<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut log = WriteOptions::new()
        .profile("ros2")
        .compression(compression)
        .compression_threads(0)
        .chunk_size(Some(150))
        .calculate_chunk_crcs(checksums)
        .calculate_data_section_crc(checksums)
        .create(Cursor::new(&mut bytes))?;
    for (i, name) in (0u8..).zip(TYPES) {
        let schema = log.add_schema(name, "ros2msg", b"")?;
        let channel = log.add_channel(schema, &format!("/{i}"), "cdr", &BTreeMap::new())?;
        let header = records::MessageHeader {
            channel_id: channel,
            sequence: 0,
            log_time: i.into(),
            publish_time: 0,
        };
        log.write_to_known_channel(&header, payload(i))?;
    }
    log.write_metadata(&records::Metadata {
        name: "horus".to_owned(),
        metadata: BTreeMap::new(),
    })?;
    log.finish()?;
    drop(log);
    Ok(bytes)
}
