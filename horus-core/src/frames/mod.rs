//! Maps, scans and poses as compact frames, for firmware that logs over a serial line.
//!
//! A [`MapStream`] turns every tick of a mapping loop into frames and hands each, finished, to the
//! caller's sink (a UART, a DMA queue, a socket); `horus-host record` turns the stream into the MCAP
//! log that a run on the host writes. Nothing is allocated: a frame is built in a caller-provided
//! buffer of at least [`MIN_BUFFER`] bytes, and what does not fit goes on in the next frame.
//!
//! # A frame
//! | bytes | field |
//! |---|---|
//! | 2 | [`SYNC`], which never occurs in UTF-8 text: text may be printed between frames |
//! | 1 | format version, [`VERSION`] |
//! | 1 | [`FrameKind`] |
//! | 4 | sequence number: 0 for the first frame, one more for each, wraps |
//! | 2 | bytes of payload |
//! | .. | payload |
//! | 4 | CRC-32 (IEEE 802.3) of everything between sync word and CRC |
//!
//! Little-endian; floats are their IEEE bits; a `varint` is LEB128, low 7 bits first. Payloads are
//! the types that implement [`Payload`]: one file each, which writes and reads it.
//!
//! # A tick
//! [`TickStart`], [`ScanPart`]s, with a map [`RowsPart`]s, [`TickEnd`]. A *key* tick follows a
//! [`Session`] and carries the whole map: a listener may start there, and starts there again after
//! it has lost a frame. Between key ticks only changed rectangles are sent, and both sides move
//! their window by the offset in [`TickStart`]: what comes into view is unknown (cost 255).
//!
//! # Another kind of frame
//! A variant of [`FrameKind`], a type that implements [`Payload`] in a file of its own, a line in
//! [`Frame::read`]. Another map of one byte per cell needs a variant of [`MapLayer`] only.

mod bytes;
mod crc;
mod end;
mod frame;
mod header;
mod kind;
mod layer;
mod names;
mod packer;
mod pending;
mod row_coder;
mod rows;
mod scan;
mod segment;
mod session;
mod stream;
mod tick;
mod writer;

#[cfg(test)]
mod tests;

pub use bytes::{Put, Take};
pub use end::{MapChecksum, TickEnd};
pub use frame::{Frame, Payload, Unreadable};
pub use header::{FrameHeader, SYNC, VERSION};
pub use kind::FrameKind;
pub use layer::MapLayer;
pub use names::FrameNames;

pub use rows::RowsPart;
pub use scan::ScanPart;
pub use session::Session;
pub use stream::{MapStream, StreamOptions, StreamTick};
pub use tick::TickStart;
pub use writer::FrameWriter;

/// Shortest buffer a frame is built in, bytes: every [`Session`] fits.
pub const MIN_BUFFER: usize = 256;

/// Longest frame, bytes: what a longer buffer has beyond it is not used.
pub const MAX_FRAME: usize = 4096;
