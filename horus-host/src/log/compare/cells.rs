//! Where in a grid an element of its data lies.
use crate::log::cdr::CdrValue;
use crate::log::msg::{
    Costmap, Grid, LaserScan, NumericType, OccupancyGrid, PackedElementField, Path, PoseStamped, TFMessage,
    TransformStamped,
};

/// A value of a cell in two grids.
pub(super) struct CellValue {
    /// (gx, gy).
    pub cell: [u64; 2],
    /// Name of the value.
    pub field: String,
    pub a: String,
    pub b: String,
}

/// A message that may be a grid. The defaults are those of a message that is none.
pub(super) trait Cells: CdrValue {
    /// The value that element `index` of the data belongs to, here and in `other`.
    fn cell_value(&self, _other: &Self, _index: usize) -> Option<CellValue> {
        None
    }

    /// Number of cells that differ from `other`; 0 if the grids differ in size.
    fn differing_cells(&self, _other: &Self) -> u64 {
        0
    }

    /// Takes the value of `other` in every float and in every known cell that is at most `tolerance`
    /// away from it.
    fn settle_cells(&mut self, other: &Self, tolerance: f64) {
        self.settle(other, tolerance);
    }
}

impl Cells for LaserScan {}
impl Cells for Path {}
impl Cells for PoseStamped {}
impl Cells for TFMessage {}
impl Cells for TransformStamped {}

impl Cells for OccupancyGrid {
    fn cell_value(&self, other: &Self, index: usize) -> Option<CellValue> {
        value_of_byte(self.info.width, &self.data, &other.data, index)
    }

    fn differing_cells(&self, other: &Self) -> u64 {
        if (self.info.width, self.data.len()) != (other.info.width, other.data.len()) {
            return 0;
        }
        differing_elements(&self.data, &other.data).count() as u64
    }

    fn settle_cells(&mut self, other: &Self, tolerance: f64) {
        self.settle(other, tolerance);
        settle_known(&mut self.data, &other.data, -1, tolerance);
    }
}

impl Cells for Costmap {
    fn cell_value(&self, other: &Self, index: usize) -> Option<CellValue> {
        value_of_byte(self.metadata.size_x, &self.data, &other.data, index)
    }

    fn differing_cells(&self, other: &Self) -> u64 {
        if (self.metadata.size_x, self.data.len()) != (other.metadata.size_x, other.data.len()) {
            return 0;
        }
        differing_elements(&self.data, &other.data).count() as u64
    }

    fn settle_cells(&mut self, other: &Self, tolerance: f64) {
        self.settle(other, tolerance);
        settle_known(&mut self.data, &other.data, u8::MAX, tolerance);
    }
}

impl Cells for Grid {
    fn cell_value(&self, other: &Self, index: usize) -> Option<CellValue> {
        let cell = self.cell_of(index)?;
        let in_cell = (index % self.row_stride as usize) % self.cell_stride as usize;
        let start = index - in_cell;
        let field = self.fields.iter().find_map(|field| {
            let offset = field.offset as usize;
            let len = byte_len(field.r#type)?;
            let value = (offset..offset.saturating_add(len))
                .contains(&in_cell)
                .then(|| {
                    let value =
                        |grid: &Self| text(grid.data.get(start.saturating_add(offset)..)?, field.r#type);
                    Some((value(self)?, value(other)?))
                })??;
            Some((format!("data.{}", field.name), value.0, value.1))
        });
        let byte = |grid: &Self| grid.data.get(index).map(u8::to_string);
        let (field, a, b) = match field {
            Some(found) => found,
            None => (format!("data[{index}]"), byte(self)?, byte(other)?),
        };
        Some(CellValue { cell, field, a, b })
    }

    fn differing_cells(&self, other: &Self) -> u64 {
        let layout = |grid: &Self| (grid.row_stride, grid.cell_stride, grid.data.len());
        if layout(self) != layout(other) {
            return 0;
        }
        let mut last = None;
        let new_cells = differing_elements(&self.data, &other.data).filter(|index| {
            let cell = self.cell_of(*index);
            let is_new = cell.is_some() && cell != last;
            last = cell;
            is_new
        });
        new_cells.count() as u64
    }

    fn settle_cells(&mut self, other: &Self, tolerance: f64) {
        self.settle(other, tolerance);
        let layout = |grid: &Self| (grid.row_stride, grid.cell_stride, grid.data.len());
        let cell_stride = self.cell_stride as usize;
        if layout(self) != layout(other) || cell_stride == 0 || self.fields != other.fields {
            return;
        }
        let cells = self
            .data
            .chunks_mut(cell_stride)
            .zip(other.data.chunks(cell_stride));
        for (cell, other) in cells {
            for field in &self.fields {
                let Some(len) = byte_len(field.r#type) else {
                    continue;
                };
                let at = field.offset as usize..(field.offset as usize).saturating_add(len);
                if let (Some(value), Some(other)) = (cell.get_mut(at.clone()), other.get(at)) {
                    let distance = number(value, field.r#type).zip(number(other, field.r#type));
                    let tolerance = if is_colour(field) {
                        (255.0 * tolerance).ceil()
                    } else {
                        tolerance
                    };
                    if distance.is_some_and(|(a, b)| (a - b).abs() <= tolerance) {
                        value.copy_from_slice(other);
                    }
                }
            }
        }
    }
}

impl Grid {
    /// The cell (gx, gy) that byte `index` of the data belongs to, if the strides are possible.
    fn cell_of(&self, index: usize) -> Option<[u64; 2]> {
        let (row, cell) = (self.row_stride as usize, self.cell_stride as usize);
        let gy = index.checked_div(row)?;
        let gx = (index % row).checked_div(cell)?;
        Some([gx as u64, gy as u64])
    }
}

/// Whether a field is a colour's channel, 0 to 255 for what the tolerance has as 0 to 1.
fn is_colour(field: &PackedElementField) -> bool {
    field.r#type == NumericType::Uint8 as u8
        && ["red", "green", "blue", "alpha"].contains(&field.name.as_str())
}

/// Bytes of a number of type `code`, if we know it.
fn byte_len(code: u8) -> Option<usize> {
    match code {
        code if code == NumericType::Uint8 as u8 => Some(1),
        code if code == NumericType::Float32 as u8 => Some(4),
        _ => None,
    }
}

/// The number of type `code` that `bytes` starts with.
fn number(bytes: &[u8], code: u8) -> Option<f64> {
    match byte_len(code)? {
        1 => bytes.first().map(|&byte| byte.into()),
        _ => bytes.first_chunk().map(|word| f32::from_le_bytes(*word).into()),
    }
}

/// The same as text, as short as it is exact.
fn text(bytes: &[u8], code: u8) -> Option<String> {
    let number = number(bytes, code)?;
    Some((number as f32).to_string()) // bytes and f32 are exact in f32
}

/// Takes the other value where both are known and at most `tolerance` apart.
fn settle_known<T: Copy + PartialEq + Into<f64>>(values: &mut [T], others: &[T], unknown: T, tolerance: f64) {
    if values.len() == others.len() {
        for (value, &other) in values.iter_mut().zip(others) {
            let both_known = *value != unknown && other != unknown;
            if both_known && ((*value).into() - other.into()).abs() <= tolerance {
                *value = other;
            }
        }
    }
}

fn value_of_byte<T: ToString>(width: u32, a: &[T], b: &[T], index: usize) -> Option<CellValue> {
    let width = width as usize;
    let gy = index.checked_div(width)?;
    Some(CellValue {
        cell: [(index % width) as u64, gy as u64],
        field: "data".to_owned(),
        a: a.get(index)?.to_string(),
        b: b.get(index)?.to_string(),
    })
}

fn differing_elements<'a, T: PartialEq>(a: &'a [T], b: &'a [T]) -> impl Iterator<Item = usize> {
    a.iter()
        .zip(b)
        .enumerate()
        .filter(|(_, (a, b))| a != b)
        .map(|(index, _)| index)
}
