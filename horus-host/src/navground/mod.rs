//! Configuration files in navground's form.
//!
//! # Examples
//! ```
//! use horus_host::navground::LocalMapFile;
//!
//! let file = LocalMapFile::parse("type: LocalGridMap\nwidth: 200\nresolution: 0.05\nexternal_lidars: [front]\n")?;
//! assert_eq!(file.width, 200);
//! let error = LocalMapFile::parse("type: LocalGridMap\n\nfootprint: round\n").unwrap_err();
//! assert_eq!(error.to_string(), "line 3: footprint: a footprint is rectangular, circular or none");
//! # Ok::<(), horus_host::navground::ConfigError>(())
//! ```

mod error;
mod local_map;
#[cfg(test)]
mod tests;

pub use error::ConfigError;
pub use local_map::LocalMapFile;
