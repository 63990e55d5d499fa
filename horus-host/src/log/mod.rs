//! MCAP logs: writing, reading and comparing what a mapping run produced.
//!
//! A log is one MCAP file with profile `ros2`; every channel is XCDR1 (`cdr`) with a `ros2msg`
//! definition, so ROS 2 tools, `rosbags` and viewers open it as it is. Layers, each using only the
//! ones before it: [`cdr`] (bytes), [`msg`] (message types), [`LogWriter`] and [`LogReader`]
//! (files), [`compare`] (two files).
//!
//! # Examples
//! ```
//! use horus_host::log::{LogEntry, LogReader, LogWriter, msg::{Header, OccupancyGrid}};
//!
//! let map = OccupancyGrid { header: Header::new(5, "map"), ..Default::default() };
//! let mut log = LogWriter::new(Vec::new())?;
//! log.write("/map", 5, &map)?;
//! let bytes = log.finish()?;
//!
//! for entry in LogReader::new(bytes.as_slice()) {
//!     if let LogEntry::Message(message) = entry? {
//!         assert_eq!(message.log_time_ns, 5);
//!         assert_eq!(message.decode::<OccupancyGrid>()?, map);
//!     }
//! }
//! # Ok::<(), horus_host::log::LogError>(())
//! ```
pub mod cdr;
mod chunk;
mod compare;
mod entry;
mod error;
pub mod msg;
mod qos;
mod reader;
mod record;
mod viewable;
mod writer;

pub use compare::{Comparison, Difference, DifferingPair, TopicComparison, compare, compare_with};
pub use entry::{LogChannel, LogEntry, LogMessage, ReadEnd};
pub use error::LogError;
pub use reader::LogReader;
pub use viewable::cost_to_viewable;
pub use writer::{DEFAULT_FLUSH_INTERVAL, LogWriter};

/// Longest record, compressed or decompressed chunk that is read unless the reader is told
/// otherwise: 72 MiB, a distance of four bytes in each of 4096 x 4096 cells. The writer writes none
/// longer.
pub const RECORD_LIMIT: usize = 72 << 20;

/// Message encoding of every channel we write and the only one we decode.
const MESSAGE_ENCODING: &str = "cdr";
/// Encoding of the message definitions we write.
const SCHEMA_ENCODING: &str = "ros2msg";
