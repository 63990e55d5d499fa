use std::fs::{self, File};
use std::io::{self, BufWriter};
use std::path::Path;

use clap::ValueEnum;

use super::{MapFileError, MapMode, MapYaml, pgm, png, shade};

/// The kind of image a map is saved as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum ImageFormat {
    /// Binary PGM.
    #[default]
    Pgm,
    /// PNG; in `Scale` mode unknown cells are transparent.
    Png,
}

impl ImageFormat {
    fn extension(self) -> &'static str {
        match self {
            Self::Pgm => "pgm",
            Self::Png => "png",
        }
    }
}

/// Writes a map: `path`, a YAML file, and beside it an image of the same name.
///
/// Cells are row-major from the lowest y. `Trinary`: values within the thresholds become 254 and 0,
/// others 205; `Scale`: 255 down to 0; `Raw`: the value, unknown 255. Each file gets its name when it
/// is whole, the image first.
///
/// # Errors
/// [`MapFileError::NeedsAlpha`] for a PGM of a `Scale` map with unknown cells;
/// [`MapFileError::WrongLength`]; [`MapFileError::Write`].
pub fn save(
    path: &Path,
    yaml: &MapYaml,
    (width, height): (u32, u32),
    cells: &[i8],
    format: ImageFormat,
) -> Result<(), MapFileError> {
    if u64::from(width) * u64::from(height) != cells.len() as u64 || cells.is_empty() {
        return Err(MapFileError::WrongLength {
            width,
            height,
            length: cells.len(),
        });
    }
    let needs_alpha = yaml.mode == MapMode::Scale && cells.iter().any(|value| !(0..=100).contains(value));
    if needs_alpha && format == ImageFormat::Pgm {
        return Err(MapFileError::NeedsAlpha);
    }
    let image = path.with_extension(format.extension());
    let row = |gy: u32| {
        let start = gy as usize * width as usize;
        cells[start..start + width as usize]
            .iter()
            .map(|&value| shade::pixel(value, yaml))
    };
    replace(&image, |file| match format {
        ImageFormat::Pgm => pgm::write(BufWriter::new(file), (width, height), |gy, shades| {
            for (shade, pixel) in shades.iter_mut().zip(row(gy)) {
                *shade = pixel.0;
            }
        }),
        ImageFormat::Png => {
            let written = png::write(
                BufWriter::new(file),
                (width, height),
                needs_alpha,
                |gy, pixels| {
                    for (pixel, (shade, is_opaque)) in pixels.iter_mut().zip(row(gy)) {
                        (pixel.shade, pixel.is_opaque) = (shade, is_opaque);
                    }
                },
            );
            written.map_err(io::Error::other)
        }
    })?;
    let yaml = MapYaml {
        image: image.file_name().unwrap_or_default().into(),
        ..yaml.clone()
    };
    replace(path, |mut file| {
        io::Write::write_all(&mut file, yaml.to_text().as_bytes())
    })
}

/// Writes a file under another name and gives it its own when it is whole.
fn replace(path: &Path, write: impl FnOnce(File) -> io::Result<()>) -> Result<(), MapFileError> {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(".part");
    let temporary = path.with_file_name(name);
    let written = File::create(&temporary)
        .and_then(write)
        .and_then(|()| fs::rename(&temporary, path));
    written.map_err(|source| {
        let _ = fs::remove_file(&temporary); // the first error is the one to tell
        MapFileError::Write {
            path: path.to_owned(),
            source,
        }
    })
}
