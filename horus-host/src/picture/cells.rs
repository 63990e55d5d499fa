//! Grids to be painted.

use super::PictureError;

/// A borrowed row-major grid: `index = gy * width + gx`, row 0 the lowest y.
#[derive(Debug, Clone, Copy)]
pub struct Cells<'a, T> {
    width: u32,
    height: u32,
    values: &'a [T],
}

impl<'a, T: Copy> Cells<'a, T> {
    /// Wraps `width * height` values.
    ///
    /// # Errors
    /// [`PictureError::Empty`] if there are no cells, [`PictureError::WrongLength`] if the number
    /// of values is another.
    pub fn new(width: u32, height: u32, values: &'a [T]) -> Result<Self, PictureError> {
        if width == 0 || height == 0 {
            return Err(PictureError::Empty { width, height });
        }
        if u64::from(width) * u64::from(height) != values.len() as u64 {
            return Err(PictureError::WrongLength {
                width,
                height,
                length: values.len(),
            });
        }
        Ok(Self {
            width,
            height,
            values,
        })
    }

    /// Cells along x.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Cells along y.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The values row by row, the lowest row first.
    pub(super) fn rows(&self) -> impl DoubleEndedIterator<Item = &'a [T]> {
        self.values.chunks_exact(self.width as usize)
    }
}
