/// The shape of a named buffer: a line of elements, or rows and columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Shape {
    rows: u32,
    columns: u32,
    dimensions: u8,
}

impl Shape {
    pub(super) const EMPTY: Self = Self {
        rows: 0,
        columns: 0,
        dimensions: 0,
    };

    /// One dimension: `elements` of them (at most 2^32 - 1).
    pub const fn line(elements: usize) -> Self {
        let columns = if elements > u32::MAX as usize {
            u32::MAX
        } else {
            elements as u32
        };
        Self {
            rows: 1,
            columns,
            dimensions: 1,
        }
    }

    /// Two dimensions, row-major.
    pub const fn grid(rows: u32, columns: u32) -> Self {
        Self {
            rows,
            columns,
            dimensions: 2,
        }
    }

    /// 1 or 2.
    pub const fn dimensions(&self) -> u8 {
        self.dimensions
    }

    /// Rows; 1 for a line.
    pub const fn rows(&self) -> u32 {
        self.rows
    }

    /// Elements of a row.
    pub const fn columns(&self) -> u32 {
        self.columns
    }

    /// All elements; `None` if they cannot be counted.
    pub const fn elements(&self) -> Option<usize> {
        (self.rows as usize).checked_mul(self.columns as usize)
    }
}
