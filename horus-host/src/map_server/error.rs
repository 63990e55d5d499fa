use std::{io, path::PathBuf};

use thiserror::Error;

use crate::yaml::YamlError;

/// Why a map was not read or written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum MapFileError {
    /// A file could not be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// A file could not be written.
    #[error("cannot write {}: {source}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// The text is no YAML, or a key is missing, given twice, or has a value that no map can have.
    #[error("{}: {source}", path.display())]
    Yaml {
        /// The file.
        path: PathBuf,
        /// What is wrong, and where.
        source: YamlError,
    },
    /// The image is neither PGM nor PNG.
    #[error("{} is neither a PGM (P2, P5) nor a PNG image", path.display())]
    Format {
        /// The file.
        path: PathBuf,
    },
    /// The image is damaged.
    #[error("{}: {what}", path.display())]
    Image {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        what: String,
    },
    /// The image has no pixels, or more than a map may have cells.
    #[error(
        "{}: a map of {width} x {height} cells is not possible: it needs 1 to {} cells",
        path.display(), super::MapFile::MOST_CELLS
    )]
    Size {
        /// The file.
        path: PathBuf,
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
    },
    /// Cells that are not width times height.
    #[error("a map of {width} x {height} cells cannot have {length} values")]
    WrongLength {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
        /// Number of values given.
        length: usize,
    },
    /// Unknown cells are transparent in this mode, and PGM has no transparency.
    #[error("scale mode keeps unknown cells as transparent pixels, which a PGM image cannot hold: use png")]
    NeedsAlpha,
}
