use super::super::Lattice;
use super::ScanClass;
use crate::error::{Buffer, Error, require};

/// Bytes that a [`SensorGrid`](super::SensorGrid) of a lattice takes: two bits per cell, and a
/// border of vacuous cells.
///
/// ```
/// assert_eq!(horus_core::evidence::class_bytes(128, 128), 34 * 130);
/// ```
pub const fn class_bytes(rows: u32, cols: u32) -> usize {
    stride(rows).saturating_mul(cols as usize + 2)
}

/// Bytes of one line along x: its cells, one more at each end, and one byte so that every pair of
/// cells lies in two bytes.
const fn stride(rows: u32) -> usize {
    (rows as usize + 2).div_ceil(4) + 1
}

/// Two bits per cell of a lattice within a border of vacuous cells, borrowed.
#[derive(Debug)]
pub(crate) struct Classes<'a> {
    bytes: &'a mut [u8],
    rows: u32,
    cols: u32,
}

impl<'a> Classes<'a> {
    pub(crate) fn new_in(bytes: &'a mut [u8], lattice: &Lattice) -> Result<Self, Error> {
        let needed = class_bytes(lattice.rows, lattice.cols);
        require(Buffer::Classes, needed, bytes.len())?;
        let bytes = bytes.get_mut(..needed).unwrap_or_default();
        bytes.fill(0);
        Ok(Self {
            bytes,
            rows: lattice.rows,
            cols: lattice.cols,
        })
    }

    pub(crate) fn clear(&mut self) {
        self.bytes.fill(0);
    }

    /// The line of cells of a column, to be written anew.
    pub(crate) fn line(&mut self, col: u32) -> Line<'_> {
        let stride = stride(self.rows);
        let start = (col as usize + 1) * stride;
        let bytes = self.bytes.get_mut(start..start + stride).unwrap_or_default();
        Line {
            bytes: bytes.iter_mut(),
            pending: 0,
            // The border cell comes first.
            filled: 2,
        }
    }

    pub(crate) fn class(&self, row: u32, col: u32) -> ScanClass {
        let lattice = [self.rows, self.cols];
        ScanClass::of_bits(quad(self.bytes, lattice, row as i32, col as i32) & 3)
    }

    #[inline]
    pub(crate) fn quad(&self, row: i32, col: i32) -> u8 {
        quad(self.bytes, [self.rows, self.cols], row, col)
    }
}

/// The class of a cell, outside vacuous, in the bytes that a [`Classes`] of the lattice has written.
pub(crate) fn class_at(bytes: &[u8], lattice: &Lattice, row: u32, col: u32) -> ScanClass {
    let size = [lattice.rows, lattice.cols];
    ScanClass::of_bits(quad(bytes, size, row as i32, col as i32) & 3)
}

/// The classes of cells (row, col), (row + 1, col), (row, col + 1), (row + 1, col + 1), two bits
/// each from the lowest; 0 outside.
#[inline]
fn quad(bytes: &[u8], [rows, cols]: [u32; 2], row: i32, col: i32) -> u8 {
    let (x, y) = (row.wrapping_add(1) as u32, col.wrapping_add(1) as u32);
    if x > rows || y > cols {
        return 0;
    }
    let stride = stride(rows);
    let start = y as usize * stride + (x >> 2) as usize;
    // One check for both lines.
    let Some(both) = bytes.get(start..).and_then(|bytes| bytes.get(..stride + 2)) else {
        return 0;
    };
    let (first, second) = both.split_at(stride);
    let pair = |bytes: &[u8]| {
        let bytes = bytes.first_chunk::<2>().copied().unwrap_or_default();
        u16::from_le_bytes(bytes) >> ((x & 3) << 1) & 15
    };
    (pair(first) | pair(second) << 4) as u8
}

/// Writes the classes of a line, from row 0 on.
pub(crate) struct Line<'a> {
    bytes: core::slice::IterMut<'a, u8>,
    pending: u8,
    filled: u32,
}

impl Line<'_> {
    #[inline]
    pub(crate) fn push(&mut self, class: ScanClass) {
        self.pending |= (class as u8) << self.filled;
        self.filled += 2;
        if self.filled == 8 {
            self.flush();
        }
    }

    /// Writes what is left, and clears the rest of the line.
    pub(crate) fn finish(mut self) {
        self.flush();
        self.bytes.for_each(|byte| *byte = 0);
    }

    #[inline]
    fn flush(&mut self) {
        if let Some(byte) = self.bytes.next() {
            *byte = self.pending;
        }
        self.pending = 0;
        self.filled = 0;
    }
}
