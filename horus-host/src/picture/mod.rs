//! Pictures of maps: PNG files to look at, and small character windows for mismatch reports.
//!
//! [`Cells`] wraps a row-major grid, [`Picture`] paints it with one of the palettes of
//! [`palette`] (those of RViz, so that a picture and a viewer show the same colours), and
//! [`ascii_window`] prints the surroundings of one cell. In both, row 0, the lowest y, is at the
//! bottom.

mod ascii;
mod cells;
mod error;
mod image;
mod indexed;
pub mod palette;
mod pixels;
mod strip;
#[cfg(test)]
mod tests;

use std::path::Path;

pub use self::ascii::ascii_window;
pub use self::cells::Cells;
pub use self::error::PictureError;
pub use self::image::Picture;
pub use self::indexed::indexed_png;
pub use self::pixels::{Pixels, Rgb};

/// Writes an occupancy grid (-1 unknown, 0 to 100) as a PNG file, `scale` pixels to a cell.
///
/// # Errors
/// As [`Picture::paint`] and [`Picture::save`].
pub fn occupancy_png(path: &Path, cells: Cells<'_, i8>, scale: u32) -> Result<(), PictureError> {
    Picture::paint(cells, scale, palette::occupancy)?.save(path)
}

/// Writes a cost map (0 to 255) as a PNG file, `scale` pixels to a cell. `lethal_cost` is that of
/// the map's parameters.
///
/// # Errors
/// As [`Picture::paint`] and [`Picture::save`].
pub fn cost_png(path: &Path, cells: Cells<'_, u8>, lethal_cost: u8, scale: u32) -> Result<(), PictureError> {
    Picture::paint(cells, scale, |cost| palette::cost(cost, lethal_cost))?.save(path)
}

/// Writes where two grids of the same shape differ as a PNG file, `scale` pixels to a cell
/// ([`palette::difference`]).
///
/// # Errors
/// As [`Picture::paint_difference`] and [`Picture::save`].
pub fn difference_png<T: Copy + Ord>(
    path: &Path,
    first: Cells<'_, T>,
    second: Cells<'_, T>,
    scale: u32,
) -> Result<(), PictureError> {
    Picture::paint_difference(first, second, scale)?.save(path)
}
