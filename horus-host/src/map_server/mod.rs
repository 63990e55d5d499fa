//! Maps as files, as nav2's `map_server` reads and writes them: `map.yaml` beside a PGM or PNG image.
//!
//! [`MapYaml`] is the text, [`MapFile`] the map with its cells, [`save`] writes both. Images are read
//! row by row: a large map costs one byte per cell. The top row of an image is the highest y.
//!
//! # Examples
//! ```
//! use horus_host::map_server::{ImageFormat, MapFile, MapMode, MapYaml, save};
//!
//! let directory = std::env::temp_dir().join(format!("horus-map-{}", std::process::id()));
//! std::fs::create_dir_all(&directory)?;
//! let yaml = MapYaml::new(0.05, [-1.0, -1.0, 0.0], MapMode::Trinary);
//! let cells = [0, 100, -1, 0];
//! save(&directory.join("room.yaml"), &yaml, (2, 2), &cells, ImageFormat::Pgm)?;
//!
//! let map = MapFile::load(&directory.join("room.yaml"), &mut |_, _| {})?;
//! assert_eq!((map.width, map.height, &map.cells[..]), (2, 2, &cells[..]));
//! assert_eq!(map.counts()[&0], 2);
//! # std::fs::remove_dir_all(&directory)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod file;
mod image;
mod mode;
mod pgm;
mod png;
mod save;
mod shade;
#[cfg(test)]
mod tests;
mod yaml;

pub use error::MapFileError;
pub use file::MapFile;
pub use mode::MapMode;
pub use save::{ImageFormat, save};
pub use yaml::MapYaml;
