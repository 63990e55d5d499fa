use std::{io, path::PathBuf};

use thiserror::Error;

use super::cdr::CdrError;

/// Why a log could not be written or read.
///
/// An `offset` is a position in the file, in bytes: of the record at fault, or of the chunk that
/// record lies in.
#[derive(Debug, Error)]
pub enum LogError {
    /// The file of a log could not be created.
    #[error("cannot create the log {}: {source}", path.display())]
    Create {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// The file of a log could not be opened.
    #[error("cannot open the log {}: {source}", path.display())]
    Open {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// Something went wrong in one of several files.
    #[error("{}: {source}", path.display())]
    InFile {
        /// The file.
        path: PathBuf,
        /// What went wrong in it.
        source: Box<LogError>,
    },
    /// The log could not be written.
    #[error("cannot write the log: {source}")]
    Write {
        /// What the container writer said.
        source: mcap::McapError,
    },
    /// A message cannot be represented as a payload.
    #[error("cannot encode a message for topic {topic}: {source}")]
    Encode {
        /// Topic the message was meant for.
        topic: String,
        /// What cannot be represented.
        source: CdrError,
    },
    /// A message is longer than readers accept.
    #[error("a message of {len} bytes for topic {topic} exceeds the limit of {limit} bytes")]
    MessageTooLong {
        /// Topic the message was meant for.
        topic: String,
        /// Length of its payload.
        len: usize,
        /// Longest payload written.
        limit: usize,
    },
    /// A topic got messages of two types.
    #[error("topic {topic} holds {logged}, so it cannot take {given}")]
    TopicType {
        /// The topic.
        topic: String,
        /// Type of its first message.
        logged: String,
        /// Type of the message refused.
        given: &'static str,
    },
    /// The file has no bytes.
    #[error("the file is empty")]
    Empty,
    /// The file does not start with the MCAP magic bytes.
    #[error("the file is not an MCAP file")]
    NotMcap,
    /// Bytes could not be read from the source.
    #[error("cannot read the log at byte {offset}: {source}")]
    Read {
        /// How far reading had come.
        offset: u64,
        /// What the system said.
        source: io::Error,
    },
    /// The container is damaged: a bad checksum, a length beyond the limit, a bad chunk.
    #[error("the log is damaged at byte {offset}: {source}")]
    Damaged {
        /// The record at fault.
        offset: u64,
        /// What the container reader said.
        source: mcap::McapError,
    },
    /// A record's own fields contradict each other.
    #[error("the log is damaged at byte {offset}: {what}")]
    Malformed {
        /// The record at fault.
        offset: u64,
        /// What is wrong with it.
        what: &'static str,
    },
    /// A message was to be decoded that is not `cdr`.
    #[error("topic {topic} is encoded as {encoding:?}, and only cdr is decoded")]
    NotCdr {
        /// Topic of the message.
        topic: String,
        /// Its message encoding.
        encoding: String,
    },
    /// A message was to be decoded as another type.
    #[error("topic {topic} holds {logged}, not {wanted}")]
    WrongType {
        /// Topic of the message.
        topic: String,
        /// Its type.
        logged: String,
        /// The type asked for.
        wanted: &'static str,
    },
    /// A payload does not decode.
    #[error("cannot decode a message of topic {topic} at byte {offset}: {source}")]
    Decode {
        /// Topic of the message.
        topic: String,
        /// Where the message lies.
        offset: u64,
        /// What is wrong with the payload.
        source: CdrError,
    },
}
