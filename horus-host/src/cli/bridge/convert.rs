//! Messages of logs as messages of topics, and back.

use horus_host::log::msg::{
    Costmap, CostmapMetaData, Grid, Header, LaserScan, MapMetaData, NumericType, OccupancyGrid,
    PackedElementField, Pose, Quaternion, TFMessage, Time, Transform, TransformStamped, Vector2, Vector3,
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

/// Header and the named values of every cell, if they are all there as 32-bit floats and the cells are
/// packed by rows.
pub fn values<const N: usize>(grid: &Grid, names: [&str; N]) -> Option<(GridHeader, Vec<[f32; N]>)> {
    let mut offsets = [0; N];
    for (offset, name) in offsets.iter_mut().zip(names) {
        let is_it =
            |field: &&PackedElementField| field.name == name && field.r#type == NumericType::Float32 as u8;
        *offset = grid.fields.iter().find(is_it)?.offset as usize;
    }
    let (row, cell, columns) = (
        grid.row_stride as usize,
        grid.cell_stride as usize,
        grid.column_count as usize,
    );
    if cell == 0 || row != columns.checked_mul(cell)? || row == 0 || !grid.data.len().is_multiple_of(row) {
        return None;
    }
    let mut cells = Vec::with_capacity(grid.data.len() / cell);
    for cell in grid.data.chunks_exact(cell) {
        let mut values = [0.0; N];
        for (value, offset) in values.iter_mut().zip(offsets) {
            *value = f32::from_le_bytes(*cell.get(offset..)?.first_chunk()?);
        }
        cells.push(values);
    }
    let header = GridHeader {
        timestamp_ns: stamp(grid.timestamp),
        origin: origin(&grid.pose),
        resolution: grid.cell_size.x as f32,
        width: grid.column_count,
        height: u32::try_from(grid.data.len() / row).ok()?,
        frame_id: frame_bytes(&grid.frame_id),
        ..GridHeader::default()
    };
    Some((header, cells))
}

/// A grid with the named values.
pub fn grid<const N: usize>(
    header: &GridHeader,
    names: [&str; N],
    cells: impl Iterator<Item = [f32; N]>,
) -> Grid {
    let stride = 4 * N as u32;
    let side = f64::from(header.resolution);
    let field = |(i, name): (u32, &str)| PackedElementField::new(name, 4 * i, NumericType::Float32);
    Grid {
        timestamp: Time::from_ns(header.timestamp_ns),
        frame_id: frame_name(&header.frame_id),
        pose: pose(header.origin),
        column_count: header.width,
        cell_size: Vector2 { x: side, y: side },
        row_stride: header.width.saturating_mul(stride),
        cell_stride: stride,
        fields: (0..).zip(names).map(field).collect(),
        data: cells.flatten().flat_map(f32::to_le_bytes).collect(),
    }
}
