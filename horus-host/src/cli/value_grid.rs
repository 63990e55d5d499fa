//! Grids of named 32-bit floats.

use horus_host::log::msg::{Grid, NumericType, PackedElementField, Pose, Time, Vector2};
use horus_host::picture::palette;
use horus_host::topic::{GridHeader, frame_bytes, frame_name};

/// Names of the values in grids of the logs.
pub const DISTANCE: [&str; 1] = ["distance"];
pub const EVIDENCE: [&str; 2] = ["free", "occupied"];

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
        timestamp_ns: grid.timestamp.to_ns().unwrap_or(0),
        origin: [
            grid.pose.position.x,
            grid.pose.position.y,
            grid.pose.orientation.yaw(),
        ],
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
    let [x, y, yaw] = header.origin;
    let field = |(i, name): (u32, &str)| PackedElementField::new(name, 4 * i, NumericType::Float32);
    Grid {
        timestamp: Time::from_ns(header.timestamp_ns),
        frame_id: frame_name(&header.frame_id),
        pose: Pose::planar(x, y, yaw),
        column_count: header.width,
        cell_size: Vector2 { x: side, y: side },
        row_stride: header.width.saturating_mul(stride),
        cell_stride: stride,
        fields: (0..).zip(names).map(field).collect(),
        data: cells.flatten().flat_map(f32::to_le_bytes).collect(),
    }
}

/// A grid of evidence as logs hold it: masses, what is unknown, and colours.
pub fn evidence(header: &GridHeader, masses: impl Iterator<Item = [f64; 2]>) -> Grid {
    Grid {
        row_stride: header.width.saturating_mul(EVIDENCE_BYTES),
        cell_stride: EVIDENCE_BYTES,
        fields: evidence_fields(),
        data: evidence_bytes(masses),
        ..grid(header, EVIDENCE, std::iter::empty())
    }
}

/// Bytes of a cell of evidence in logs.
pub const EVIDENCE_BYTES: u32 = 16;

pub fn evidence_fields() -> Vec<PackedElementField> {
    let of = |names: &[&str], at: u32, size: u32, kind: NumericType| -> Vec<_> {
        let field = |(i, name): (u32, &&str)| PackedElementField::new(name, at + size * i, kind);
        (0..).zip(names).map(field).collect()
    };
    let masses = of(&["free", "occupied", "unknown"], 0, 4, NumericType::Float32);
    let colours = of(&["red", "green", "blue", "alpha"], 12, 1, NumericType::Uint8);
    [masses, colours].concat()
}

pub fn evidence_bytes(masses: impl Iterator<Item = [f64; 2]>) -> Vec<u8> {
    let mut data = Vec::new();
    for [free, occupied] in masses {
        for mass in [free, occupied, (1.0 - free - occupied).max(0.0)] {
            data.extend((mass as f32).to_le_bytes());
        }
        data.extend(palette::evidence([free, occupied]).0);
        data.push(u8::MAX);
    }
    data
}
