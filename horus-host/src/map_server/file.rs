use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use super::image::{ImageRows, Pixel, in_file};
use super::shade::Shades;
use super::{MapFileError, MapYaml};

/// A map that was read from its files.
#[derive(Debug, Clone, PartialEq)]
pub struct MapFile {
    /// What the YAML file says.
    pub yaml: MapYaml,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Occupancy, row-major from the lowest y: -1 unknown, 0 free to 100 occupied.
    pub cells: Vec<i8>,
}

impl MapFile {
    /// The largest number of cells of a map: 4096 x 4096.
    pub const MOST_CELLS: u64 = 1 << 24;

    /// Reads `path` and the image it names; `progress` is told the rows read and all rows.
    ///
    /// The shade of a coloured pixel is its Rec. 709 luma; shades of more than 8 bits are rounded.
    ///
    /// # Errors
    /// Whatever is wrong with either file, see [`MapFileError`].
    ///
    /// # Complexity
    /// One visit per pixel; one byte of memory per cell and one row of pixels (an interlaced PNG is
    /// held whole).
    pub fn load(path: &Path, progress: &mut dyn FnMut(u32, u32)) -> Result<Self, MapFileError> {
        let text = fs::read_to_string(path).map_err(|source| MapFileError::Read {
            path: path.to_owned(),
            source,
        })?;
        let yaml = MapYaml::parse(path, &text)?;
        let image = path.parent().unwrap_or(Path::new("")).join(&yaml.image);
        let mut rows = ImageRows::open(&image)?;
        let (width, height) = rows.size();
        let refuse = || MapFileError::Size {
            path: image.clone(),
            width,
            height,
        };
        let len = match u64::from(width) * u64::from(height) {
            cells @ 1..=Self::MOST_CELLS => cells as usize,
            _ => return Err(refuse()),
        };
        let mut cells = Vec::new();
        cells.try_reserve_exact(len).map_err(|_| refuse())?;
        cells.resize(len, 0);
        let shades = Shades::new(&yaml);
        let mut pixels = vec![
            Pixel {
                shade: 0,
                is_opaque: true
            };
            width as usize
        ];
        for (done, row) in (1..).zip(cells.chunks_exact_mut(width as usize).rev()) {
            rows.next_row(&mut pixels)
                .map_err(|error| in_file(&image, &error))?;
            for (cell, pixel) in row.iter_mut().zip(&pixels) {
                *cell = shades.value(pixel.shade, pixel.is_opaque);
            }
            progress(done, height);
        }
        Ok(Self {
            yaml,
            width,
            height,
            cells,
        })
    }

    /// How many cells have each value.
    pub fn counts(&self) -> BTreeMap<i8, u64> {
        let mut counts = [0u64; 256];
        for &cell in &self.cells {
            counts[usize::from(cell as u8)] += 1;
        }
        let with_value = (i8::MIN..=i8::MAX).map(|value| (value, counts[usize::from(value as u8)]));
        with_value.filter(|&(_, count)| count > 0).collect()
    }
}
