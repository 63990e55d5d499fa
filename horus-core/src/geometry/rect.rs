/// A half-open rectangle of cells: `x0 <= gx < x1`, `y0 <= gy < y1`, in grid indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(C)]
pub struct CellRect {
    /// First column.
    pub x0: u32,
    /// First row.
    pub y0: u32,
    /// One past the last column.
    pub x1: u32,
    /// One past the last row.
    pub y1: u32,
}

impl CellRect {
    /// Columns.
    pub const fn width(&self) -> u32 {
        self.x1.saturating_sub(self.x0)
    }

    /// Rows.
    pub const fn height(&self) -> u32 {
        self.y1.saturating_sub(self.y0)
    }

    /// True if the cell lies in the rectangle.
    pub const fn contains(&self, gx: u32, gy: u32) -> bool {
        self.x0 <= gx && gx < self.x1 && self.y0 <= gy && gy < self.y1
    }

    /// The smallest rectangle that holds both.
    pub fn union(&self, other: &Self) -> Self {
        Self {
            x0: self.x0.min(other.x0),
            y0: self.y0.min(other.y0),
            x1: self.x1.max(other.x1),
            y1: self.y1.max(other.y1),
        }
    }
}

/// Grows to the bounding box of the cells it is shown.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    x0: u32,
    y0: u32,
    x1: u32,
    y1: u32,
}

impl Bounds {
    pub(crate) const EMPTY: Self = Self {
        x0: u32::MAX,
        y0: u32::MAX,
        x1: 0,
        y1: 0,
    };

    #[inline]
    pub(crate) fn add(&mut self, gx: u32, gy: u32) {
        self.add_span(gx, gx + 1, gy);
    }

    /// Adds the cells `x0 <= gx < x1` of row `gy`; the span is not empty.
    #[inline]
    pub(crate) fn add_span(&mut self, x0: u32, x1: u32, gy: u32) {
        self.x0 = self.x0.min(x0);
        self.x1 = self.x1.max(x1);
        self.y0 = self.y0.min(gy);
        self.y1 = self.y1.max(gy + 1);
    }

    /// Adds the cells of a rectangle that is not empty.
    pub(crate) fn add_rect(&mut self, rect: CellRect) {
        self.add_span(rect.x0, rect.x1, rect.y0);
        self.y1 = self.y1.max(rect.y1);
    }

    pub(crate) fn rect(&self) -> Option<CellRect> {
        let Self { x0, y0, x1, y1 } = *self;
        (x0 < x1 && y0 < y1).then_some(CellRect { x0, y0, x1, y1 })
    }
}
