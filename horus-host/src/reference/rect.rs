/// A half-open rectangle of cells: columns `x0..x1`, rows `y0..y1`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Rect {
    /// First column.
    pub x0: u32,
    /// First row.
    pub y0: u32,
    /// Column after the last one.
    pub x1: u32,
    /// Row after the last one.
    pub y1: u32,
}

impl Rect {
    /// The smallest rectangle holding every one of `cells`, `None` if there are none.
    pub(super) fn around(cells: impl Iterator<Item = (u32, u32)>) -> Option<Self> {
        cells.fold(None, |rect, (x, y)| {
            let r = rect.unwrap_or(Self {
                x0: x,
                y0: y,
                x1: x + 1,
                y1: y + 1,
            });
            Some(Self {
                x0: r.x0.min(x),
                y0: r.y0.min(y),
                x1: r.x1.max(x + 1),
                y1: r.y1.max(y + 1),
            })
        })
    }
}
