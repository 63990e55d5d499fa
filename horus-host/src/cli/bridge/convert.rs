//! Messages of logs as messages of topics, and back.

use horus_core::local::{FREE, OCCUPIED};
use horus_host::log::msg::{
    Costmap, CostmapMetaData, Header, LaserScan, MapMetaData, OccupancyGrid, Pose, Quaternion, TFMessage,
    Time, Transform, TransformStamped, Vector3,
};
use horus_host::topic::{GridHeader, ScanHeader, TransformEntry, TransformHeader, frame_bytes, frame_name};

fn stamp(stamp: Time) -> u64 {
    stamp.to_ns().unwrap_or(0)
}

fn origin(pose: &Pose) -> [f64; 3] {
    [pose.position.x, pose.position.y, pose.orientation.yaw()]
}

fn pose([x, y, yaw]: [f64; 3]) -> Pose {
    Pose::planar(x, y, yaw)
}

fn stamped(header: &GridHeader) -> Header {
    Header::new(header.timestamp_ns, &frame_name(&header.frame_id))
}

pub fn map_header(map: &OccupancyGrid) -> GridHeader {
    GridHeader {
        timestamp_ns: stamp(map.header.stamp),
        origin: origin(&map.info.origin),
        resolution: map.info.resolution,
        width: map.info.width,
        height: map.info.height,
        frame_id: frame_bytes(&map.header.frame_id),
        ..GridHeader::default()
    }
}

pub fn map(header: &GridHeader, cells: &[i8]) -> OccupancyGrid {
    OccupancyGrid {
        header: stamped(header),
        info: MapMetaData {
            map_load_time: Time::default(),
            resolution: header.resolution,
            width: header.width,
            height: header.height,
            origin: pose(header.origin),
        },
        data: cells.to_vec(),
    }
}

/// A navground local map as an occupancy grid, which is how logs hold it.
pub fn local_map(header: &GridHeader, cells: &[u8]) -> OccupancyGrid {
    let occupancy = |value: &u8| match *value {
        OCCUPIED => 100,
        FREE => 0,
        _ => -1,
    };
    map(header, &cells.iter().map(occupancy).collect::<Vec<_>>())
}

pub fn costs_header(map: &Costmap) -> GridHeader {
    GridHeader {
        timestamp_ns: stamp(map.header.stamp),
        origin: origin(&map.metadata.origin),
        resolution: map.metadata.resolution,
        width: map.metadata.size_x,
        height: map.metadata.size_y,
        frame_id: frame_bytes(&map.header.frame_id),
        ..GridHeader::default()
    }
}

pub fn costs(header: &GridHeader, cells: &[u8]) -> Costmap {
    let stamped = stamped(header);
    Costmap {
        metadata: CostmapMetaData {
            map_load_time: Time::default(),
            update_time: stamped.stamp,
            layer: "master".to_owned(),
            resolution: header.resolution,
            size_x: header.width,
            size_y: header.height,
            origin: pose(header.origin),
        },
        header: stamped,
        data: cells.to_vec(),
    }
}

pub fn scan_header(scan: &LaserScan) -> ScanHeader {
    ScanHeader {
        timestamp_ns: stamp(scan.header.stamp),
        angle_min: scan.angle_min,
        angle_increment: scan.angle_increment,
        range_min: scan.range_min,
        range_max: scan.range_max,
        time_increment: scan.time_increment,
        scan_time: scan.scan_time,
        beams: scan.ranges.len() as u32,
        frame_id: frame_bytes(&scan.header.frame_id),
        ..ScanHeader::default()
    }
}

pub fn scan(header: &ScanHeader, ranges: &[f32]) -> LaserScan {
    let last_beam = ranges.len().saturating_sub(1) as f32;
    LaserScan {
        header: Header::new(header.timestamp_ns, &frame_name(&header.frame_id)),
        angle_min: header.angle_min,
        angle_max: header.angle_min + last_beam * header.angle_increment,
        angle_increment: header.angle_increment,
        time_increment: header.time_increment,
        scan_time: header.scan_time,
        range_min: header.range_min,
        range_max: header.range_max,
        ranges: ranges.to_vec(),
        intensities: Vec::new(),
    }
}

pub fn transforms(
    message: &TFMessage,
    stamp_ns: u64,
    is_static: bool,
) -> (TransformHeader, Vec<TransformEntry>) {
    let entry = |transform: &TransformStamped| {
        let (t, q) = (&transform.transform.translation, &transform.transform.rotation);
        TransformEntry {
            timestamp_ns: stamp(transform.header.stamp),
            parent: frame_bytes(&transform.header.frame_id),
            child: frame_bytes(&transform.child_frame_id),
            translation: [t.x, t.y, t.z],
            rotation: [q.x, q.y, q.z, q.w],
        }
    };
    let header = TransformHeader {
        timestamp_ns: stamp_ns,
        count: message.transforms.len() as u32,
        is_static: u32::from(is_static),
    };
    (header, message.transforms.iter().map(entry).collect())
}

pub fn tf(entries: &[TransformEntry]) -> TFMessage {
    let stamped = |entry: &TransformEntry| {
        let ([x, y, z], [qx, qy, qz, qw]) = (entry.translation, entry.rotation);
        TransformStamped {
            header: Header::new(entry.timestamp_ns, &frame_name(&entry.parent)),
            child_frame_id: frame_name(&entry.child),
            transform: Transform {
                translation: Vector3 { x, y, z },
                rotation: Quaternion {
                    x: qx,
                    y: qy,
                    z: qz,
                    w: qw,
                },
            },
        }
    };
    TFMessage {
        transforms: entries.iter().map(stamped).collect(),
    }
}
