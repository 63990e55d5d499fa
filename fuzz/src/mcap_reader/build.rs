//! Logs put together record by record, each right or wrong in its own way.

use arbitrary::Arbitrary;
use mcap::records::op;

use super::{Damage, samples};
use crate::sequence::{Rest, Short};

/// A log.
#[derive(Clone, Debug, Arbitrary)]
pub struct BuiltLog {
    /// It ends as it should.
    finished: bool,
    damage: Option<Damage>,
    records: Rest<Record>,
}

/// A record and how its length is written.
#[derive(Clone, Debug, Arbitrary)]
pub struct Record {
    entry: Entry,
    /// Written instead of the right length.
    length: Option<u64>,
}

/// What a record says.
#[derive(Clone, Debug, Arbitrary)]
pub enum Entry {
    /// Opcode 1.
    Header(Text, Text),
    /// A schema of a known type.
    Schema {
        /// Its id.
        id: u8,
        /// Which type.
        kind: u8,
    },
    /// A schema of any type.
    AnySchema {
        /// Its id.
        id: u16,
        /// Type name.
        name: Text,
        /// Definition.
        data: Text,
    },
    /// A channel.
    Channel {
        /// Its id.
        id: u8,
        /// Its schema's.
        schema: u8,
        /// Topic.
        topic: Text,
        /// Not `cdr`.
        encoding: Option<Text>,
        /// As stored.
        metadata: Text,
    },
    /// A message.
    Message {
        /// Its channel's id.
        channel: u8,
        /// When.
        stamp: u64,
        /// What.
        payload: Payload,
    },
    /// A chunk.
    Chunk {
        /// What it holds.
        records: Short<Record, 6>,
        /// What it says its size is.
        size: Option<u64>,
        /// What it says its compressed size is.
        compressed: Option<u64>,
        /// Its checksum.
        checksum: Checksum,
        /// Its compression; what it holds is never compressed.
        compression: Option<Text>,
    },
    /// A metadata record.
    Metadata(Text, Short<(Text, Text), 6>),
    /// The end of the data, with a checksum.
    DataEnd(u32),
    /// The footer.
    Footer(u64),
    /// Any record.
    Any(u8, Vec<u8>),
}

/// A text and how its length is written.
#[derive(Clone, Debug, Arbitrary)]
pub struct Text {
    bytes: Short<u8, 30>,
    length: Option<u32>,
}

/// A message's bytes.
#[derive(Clone, Debug, Arbitrary)]
pub enum Payload {
    /// Any.
    Bytes(Vec<u8>),
    /// Any fields after the encapsulation header.
    Fields(bool, Vec<u8>),
    /// A good payload, damaged.
    Damaged(u8, Option<Damage>),
}

/// A chunk's checksum.
#[derive(Clone, Copy, Debug, Arbitrary)]
pub enum Checksum {
    /// Zero, which means none.
    None,
    /// The right one.
    Right,
    /// Any.
    Any(u32),
}

impl BuiltLog {
    /// The log's bytes.
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = mcap::MAGIC.to_vec();
        self.records.0.iter().for_each(|record| record.write(&mut bytes));
        if self.finished {
            put(&mut bytes, op::DATA_END, &[0; 4], None);
            put(&mut bytes, op::FOOTER, &[0; 20], None);
            bytes.extend_from_slice(mcap::MAGIC);
        }
        if let Some(damage) = &self.damage {
            damage.apply(&mut bytes);
        }
        bytes
    }
}

impl Record {
    fn write(&self, to: &mut Vec<u8>) {
        let mut fields = Vec::new();
        let opcode = self.entry.write(&mut fields);
        put(to, opcode, &fields, self.length);
    }
}

fn put(to: &mut Vec<u8>, opcode: u8, fields: &[u8], length: Option<u64>) {
    to.push(opcode);
    to.extend_from_slice(&length.unwrap_or(fields.len() as u64).to_le_bytes());
    to.extend_from_slice(fields);
}

impl Text {
    fn write(&self, to: &mut Vec<u8>) {
        let length = self.length.unwrap_or(self.bytes.0.len() as u32);
        to.extend_from_slice(&length.to_le_bytes());
        to.extend_from_slice(&self.bytes.0);
    }
}

fn text(to: &mut Vec<u8>, text: &str) {
    let text = Text {
        bytes: Short(text.into()),
        length: None,
    };
    text.write(to);
}

impl Entry {
    /// Writes the fields, returns the opcode.
    fn write(&self, to: &mut Vec<u8>) -> u8 {
        match self {
            Self::Header(profile, library) => {
                profile.write(to);
                library.write(to);
                op::HEADER
            }
            Self::Schema { id, kind } => {
                to.extend_from_slice(&u16::from(*id % 8).to_le_bytes());
                text(to, samples::TYPES[usize::from(*kind) % samples::TYPES.len()]);
                text(to, "ros2msg");
                text(to, "");
                op::SCHEMA
            }
            Self::AnySchema { id, name, data } => {
                to.extend_from_slice(&id.to_le_bytes());
                name.write(to);
                text(to, "ros2msg");
                data.write(to);
                op::SCHEMA
            }
            Self::Channel {
                id,
                schema,
                topic,
                encoding,
                metadata,
            } => {
                to.extend_from_slice(&u16::from(*id % 8).to_le_bytes());
                to.extend_from_slice(&u16::from(*schema % 8).to_le_bytes());
                topic.write(to);
                match encoding {
                    Some(encoding) => encoding.write(to),
                    None => text(to, "cdr"),
                }
                metadata.write(to);
                op::CHANNEL
            }
            Self::Message {
                channel,
                stamp,
                payload,
            } => {
                to.extend_from_slice(&u16::from(*channel % 8).to_le_bytes());
                to.extend_from_slice(&[0; 4]);
                to.extend_from_slice(&stamp.to_le_bytes());
                to.extend_from_slice(&stamp.to_le_bytes());
                payload.write(to);
                op::MESSAGE
            }
            Self::Chunk {
                records,
                size,
                compressed,
                checksum,
                compression,
            } => {
                let mut inner = Vec::new();
                records.0.iter().for_each(|record| record.write(&mut inner));
                let len = inner.len() as u64;
                to.extend_from_slice(&[0; 16]);
                to.extend_from_slice(&size.unwrap_or(len).to_le_bytes());
                to.extend_from_slice(&checksum.of(&inner).to_le_bytes());
                match compression {
                    Some(name) => name.write(to),
                    None => text(to, ""),
                }
                to.extend_from_slice(&compressed.unwrap_or(len).to_le_bytes());
                to.extend_from_slice(&inner);
                op::CHUNK
            }
            Self::Metadata(name, pairs) => {
                name.write(to);
                let mut map = Vec::new();
                for (key, value) in &pairs.0 {
                    key.write(&mut map);
                    value.write(&mut map);
                }
                Text {
                    bytes: Short(map),
                    length: None,
                }
                .write(to);
                op::METADATA
            }
            Self::DataEnd(checksum) => {
                to.extend_from_slice(&checksum.to_le_bytes());
                op::DATA_END
            }
            Self::Footer(start) => {
                to.extend_from_slice(&start.to_le_bytes());
                to.extend_from_slice(&[0; 12]);
                op::FOOTER
            }
            Self::Any(opcode, fields) => {
                to.extend_from_slice(fields);
                *opcode
            }
        }
    }
}

impl Payload {
    fn write(&self, to: &mut Vec<u8>) {
        match self {
            Self::Bytes(bytes) => to.extend_from_slice(bytes),
            Self::Fields(is_little, bytes) => {
                to.extend_from_slice(&[0, u8::from(*is_little), 0, 0]);
                to.extend_from_slice(bytes);
            }
            Self::Damaged(which, damage) => {
                let mut payload = samples::payload(*which).to_vec();
                if let Some(damage) = damage {
                    damage.apply(&mut payload);
                }
                to.extend_from_slice(&payload);
            }
        }
    }
}

impl Checksum {
    fn of(self, bytes: &[u8]) -> u32 {
        match self {
            Self::None => 0,
            Self::Right => crc32(bytes),
            Self::Any(checksum) => checksum,
        }
    }
}

/// The checksum of zip files.
fn crc32(bytes: &[u8]) -> u32 {
    let step = |crc: u32, _| crc >> 1 ^ (0xedb8_8320 & 0u32.wrapping_sub(crc & 1));
    !bytes
        .iter()
        .fold(u32::MAX, |crc, byte| (0..8).fold(crc ^ u32::from(*byte), step))
}
