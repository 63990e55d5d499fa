use crate::geometry::CellRect;

/// Cells of a rolling map that have changed since they were last sent.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Pending(Option<CellRect>);

impl Pending {
    /// Adds a rectangle in the window's present indices.
    pub fn add(&mut self, rect: Option<CellRect>) {
        self.0 = match (self.0, rect) {
            (Some(a), Some(b)) => Some(a.union(&b)),
            (a, b) => a.or(b),
        };
    }

    /// Follows a window that has moved by so many cells; what has left it is dropped.
    pub fn shift(&mut self, [dx, dy]: [i32; 2]) {
        // Negative coordinates become 0: those cells are gone.
        let moved = |at: u32, by: i32| (i64::from(at) - i64::from(by)).clamp(0, i64::from(u32::MAX)) as u32;
        self.0 = self.0.map(|rect| CellRect {
            x0: moved(rect.x0, dx),
            y0: moved(rect.y0, dy),
            x1: moved(rect.x1, dx),
            y1: moved(rect.y1, dy),
        });
        self.0 = self.0.filter(|rect| rect.width() > 0 && rect.height() > 0);
    }

    /// Hands the rectangle out; nothing is pending then.
    pub fn take(&mut self) -> Option<CellRect> {
        self.0.take()
    }
}
