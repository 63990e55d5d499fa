use super::Shape;

/// The contents of a named buffer, borrowed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BufferView<'s, T> {
    pub(super) shape: Shape,
    pub(super) data: &'s [T],
}

impl<'s, T> BufferView<'s, T> {
    /// Rows and columns.
    pub const fn shape(&self) -> Shape {
        self.shape
    }

    /// All elements, row-major.
    pub const fn data(&self) -> &'s [T] {
        self.data
    }
}
