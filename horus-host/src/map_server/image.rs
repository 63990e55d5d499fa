//! An image of either kind, row by row.

use std::fs::File;
use std::io::{self, BufRead, BufReader};
use std::path::Path;

use super::MapFileError;
use super::pgm::PgmReader;
use super::png::PngReader;

/// A pixel as far as maps look at it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Pixel {
    /// 0 black to 255 white.
    pub shade: u8,
    pub is_opaque: bool,
}

/// Why an image cannot be read.
#[derive(Debug, thiserror::Error)]
pub(super) enum ImageError {
    #[error("{0}")]
    Malformed(&'static str),
    #[error(transparent)]
    Png(::png::DecodingError),
    #[error(transparent)]
    Io(#[from] io::Error),
}

/// The rows of a PGM or PNG image, from the top.
pub(super) enum ImageRows {
    Pgm(PgmReader<BufReader<File>>),
    Png(Box<PngReader<BufReader<File>>>),
}

impl ImageRows {
    /// Opens an image; what it is, its first bytes tell.
    pub fn open(path: &Path) -> Result<Self, MapFileError> {
        let unreadable = |source| MapFileError::Read {
            path: path.to_owned(),
            source,
        };
        let mut source = BufReader::new(File::open(path).map_err(unreadable)?);
        let rows = match source.fill_buf().map_err(unreadable)? {
            [b'P', b'2' | b'5', ..] => PgmReader::new(source).map(Self::Pgm),
            [0x89, b'P', b'N', b'G', ..] => PngReader::new(source).map(|reader| Self::Png(Box::new(reader))),
            _ => {
                return Err(MapFileError::Format {
                    path: path.to_owned(),
                });
            }
        };
        rows.map_err(|error| in_file(path, &error))
    }

    /// Columns and rows.
    pub fn size(&self) -> (u32, u32) {
        match self {
            Self::Pgm(reader) => (reader.width, reader.height),
            Self::Png(reader) => reader.size(),
        }
    }

    pub fn next_row(&mut self, row: &mut [Pixel]) -> Result<(), ImageError> {
        match self {
            Self::Pgm(reader) => reader.next_row(row),
            Self::Png(reader) => reader.next_row(row),
        }
    }
}

pub(super) fn in_file(path: &Path, error: &ImageError) -> MapFileError {
    let what = match error {
        ImageError::Io(error) if error.kind() == io::ErrorKind::UnexpectedEof => {
            "the image ends too early".to_owned()
        }
        error => error.to_string(),
    };
    MapFileError::Image {
        path: path.to_owned(),
        what,
    }
}
