//! XCDR1, the encoding of every message payload in a ROS 2 log.
//!
//! A payload is a 4-byte encapsulation header followed by the fields in order, each aligned to
//! its own size; alignment is counted from the first byte **after** the header. We write little
//! endian (`00 01`) and read both byte orders. XCDR2, which ROS 2 does not log, is refused by name.
mod difference;
mod error;
mod primitive;
mod reader;
mod sequence;
mod value;
mod writer;

pub use difference::FieldDifference;
pub use error::CdrError;
pub use reader::CdrReader;
pub use value::{CdrValue, Definition};
pub use writer::CdrWriter;
