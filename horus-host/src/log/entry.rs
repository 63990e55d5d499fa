use std::{collections::BTreeMap, sync::Arc};

use serde::Serialize;

use super::{LogError, MESSAGE_ENCODING, msg::Message};

/// A topic of a log, as its channel record describes it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LogChannel {
    /// The topic, e.g. `/scan`.
    pub topic: String,
    /// Type of the messages, e.g. `sensor_msgs/msg/LaserScan`; empty for a channel without schema.
    pub type_name: String,
    /// Encoding of the payloads, e.g. `cdr`.
    pub encoding: String,
}

/// One message of a log.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LogMessage {
    /// The channel it belongs to.
    pub channel: Arc<LogChannel>,
    /// When it was logged, ns.
    pub log_time_ns: u64,
    /// When it was published, ns.
    pub publish_time_ns: u64,
    /// Where it lies: byte position of its record, or of the chunk that holds it.
    pub offset: u64,
    /// The payload as stored.
    pub payload: Vec<u8>,
}

impl LogMessage {
    /// The topic.
    pub fn topic(&self) -> &str {
        &self.channel.topic
    }

    /// Decodes the payload.
    ///
    /// # Errors
    /// [`LogError::NotCdr`] or [`LogError::WrongType`] if the channel holds something else,
    /// [`LogError::Decode`] if the payload is damaged.
    pub fn decode<M: Message>(&self) -> Result<M, LogError> {
        let channel = &self.channel;
        if channel.encoding != MESSAGE_ENCODING {
            return Err(LogError::NotCdr {
                topic: channel.topic.clone(),
                encoding: channel.encoding.clone(),
            });
        }
        if channel.type_name != M::TYPE {
            return Err(LogError::WrongType {
                topic: channel.topic.clone(),
                logged: channel.type_name.clone(),
                wanted: M::TYPE,
            });
        }
        M::from_payload(&self.payload).map_err(|source| LogError::Decode {
            topic: channel.topic.clone(),
            offset: self.offset,
            source,
        })
    }
}

/// What a log yields, in file order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LogEntry {
    /// A message.
    Message(LogMessage),
    /// A metadata record.
    Metadata {
        /// Name of the record.
        name: String,
        /// Its keys and values.
        values: BTreeMap<String, String>,
    },
}

/// How a log ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ReadEnd {
    /// With its footer: the log was finished.
    Complete,
    /// In the middle: everything up to `offset` was read, what follows is no whole record.
    Truncated {
        /// End of the last whole record, bytes from the start of the file.
        offset: u64,
    },
}
