//! Pictures of large maps: one byte per pixel, written row by row.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;

use png::{BitDepth, ColorType, Compression, Encoder, EncodingError};

use super::{PictureError, Rgb};

/// Writes a grid of bytes as a PNG with a palette, one pixel to a cell, without holding it.
///
/// `row` is asked for every row, the highest y first, and fills it from the lowest x.
///
/// # Errors
/// [`PictureError::Empty`]; [`PictureError::Write`], which names the path.
///
/// # Complexity
/// One byte per cell passes through; memory for one row.
pub fn indexed_png(
    path: &Path,
    (width, height): (u32, u32),
    palette: impl Fn(u8) -> Rgb,
    mut row: impl FnMut(u32, &mut [u8]),
) -> Result<(), PictureError> {
    if width == 0 || height == 0 {
        return Err(PictureError::Empty { width, height });
    }
    let colours: Vec<u8> = (0..=255).flat_map(|value| palette(value).0).collect();
    let write = || -> Result<(), EncodingError> {
        let mut encoder = Encoder::new(BufWriter::new(File::create(path)?), width, height);
        encoder.set_color(ColorType::Indexed);
        encoder.set_depth(BitDepth::Eight);
        encoder.set_palette(colours);
        encoder.set_compression(Compression::Fast);
        let mut writer = encoder.write_header()?;
        let mut stream = writer.stream_writer()?;
        let mut values = vec![0; width as usize];
        for gy in (0..height).rev() {
            row(gy, &mut values);
            stream.write_all(&values)?;
        }
        stream.finish()?;
        writer.finish()
    };
    write().map_err(|source| PictureError::Write {
        path: path.to_path_buf(),
        source,
    })
}
