//! What can go wrong with pictures.

use std::path::PathBuf;

use thiserror::Error;

/// Why a picture was not painted or written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum PictureError {
    /// A grid without cells.
    #[error("a grid of {width} x {height} cells has nothing to paint")]
    Empty {
        /// Cells along x.
        width: u32,
        /// Cells along y.
        height: u32,
    },
    /// A number of values that is not width times height.
    #[error("a grid of {width} x {height} cells cannot have {length} values")]
    WrongLength {
        /// Cells along x.
        width: u32,
        /// Cells along y.
        height: u32,
        /// The number of values given.
        length: usize,
    },
    /// Two grids to compare that differ in shape.
    #[error(
        "grids of {}x{} and {}x{} cells cannot be compared",
        first.0, first.1, second.0, second.1
    )]
    ShapesDiffer {
        /// Width and height of the first.
        first: (u32, u32),
        /// Width and height of the second.
        second: (u32, u32),
    },
    /// A scale of zero, or a picture of more pixels than allowed.
    #[error(
        "{width} x {height} cells at {scale} pixels each cannot be painted: \
         the scale must be at least 1 and the picture at most {most_pixels} pixels"
    )]
    BadScale {
        /// Cells along x.
        width: u32,
        /// Cells along y.
        height: u32,
        /// Pixels per cell and axis.
        scale: u32,
        /// The largest number of pixels allowed.
        most_pixels: u64,
    },
    /// A file that could not be written.
    #[error("cannot write the picture {}: {source}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// The reason.
        source: png::EncodingError,
    },
}
