//! The MCAP records a log is read from, out of their bytes.
//!
//! Parsed here rather than by the container crate, which trusts some length fields enough to
//! allocate for them, or to panic.
use std::collections::BTreeMap;

/// Longest topic, type or encoding name.
const NAME_LIMIT: usize = 1024;

/// Bytes in front of a record: opcode and 64-bit length.
pub(super) const PREFIX_LEN: usize = 1 + 8;

/// What is wrong with a record.
pub(super) type Malformed = &'static str;

const TOO_SHORT: Malformed = "a record is shorter than its fields";

/// A schema record, without the definition.
pub(super) struct Schema {
    pub id: u16,
    pub name: String,
}

/// A channel record, without its metadata.
pub(super) struct Channel {
    pub id: u16,
    pub schema_id: u16,
    pub topic: String,
    pub encoding: String,
}

/// A message record.
pub(super) struct Message<'a> {
    pub channel_id: u16,
    pub log_time_ns: u64,
    pub publish_time_ns: u64,
    pub payload: &'a [u8],
}

/// A chunk record: what its header says, and the bytes its records take, still compressed.
pub(super) struct Chunk<'a> {
    pub uncompressed_size: u64,
    pub is_compressed: bool,
    pub records: &'a [u8],
}

pub(super) fn schema(record: &[u8]) -> Result<Schema, Malformed> {
    let mut fields = Fields(record);
    Ok(Schema {
        id: fields.u16()?,
        name: fields.name()?,
    })
}

pub(super) fn channel(record: &[u8]) -> Result<Channel, Malformed> {
    let mut fields = Fields(record);
    Ok(Channel {
        id: fields.u16()?,
        schema_id: fields.u16()?,
        topic: fields.name()?,
        encoding: fields.name()?,
    })
}

pub(super) fn message(record: &[u8]) -> Result<Message<'_>, Malformed> {
    let mut fields = Fields(record);
    let channel_id = fields.u16()?;
    let _sequence = fields.u32()?;
    Ok(Message {
        channel_id,
        log_time_ns: fields.u64()?,
        publish_time_ns: fields.u64()?,
        payload: fields.0,
    })
}

pub(super) fn metadata(record: &[u8]) -> Result<(String, BTreeMap<String, String>), Malformed> {
    let mut fields = Fields(record);
    let name = fields.name()?;
    let len = fields.u32()? as usize;
    let mut pairs = Fields(fields.bytes(len)?);
    let mut values = BTreeMap::new();
    while !pairs.0.is_empty() {
        let key = pairs.text()?.to_owned();
        values.insert(key, pairs.text()?.to_owned());
    }
    Ok((name, values))
}

pub(super) fn chunk(record: &[u8]) -> Result<Chunk<'_>, Malformed> {
    let mut fields = Fields(record);
    let (_start_ns, _end_ns) = (fields.u64()?, fields.u64()?);
    let uncompressed_size = fields.u64()?;
    let _crc = fields.u32()?;
    let is_compressed = !fields.name()?.is_empty();
    let compressed_size = fields.u64()?;
    let len = usize::try_from(compressed_size).map_err(|_| TOO_SHORT)?;
    Ok(Chunk {
        uncompressed_size,
        is_compressed,
        records: fields.bytes(len)?,
    })
}

/// Whether `bytes` are whole records, one after the other, with nothing left over.
pub(super) fn are_whole_records(bytes: &[u8]) -> bool {
    let mut fields = Fields(bytes);
    while !fields.0.is_empty() {
        let Ok(_opcode) = fields.bytes(1) else {
            return false;
        };
        let len = fields.u64().map(usize::try_from);
        let Ok(Ok(len)) = len else { return false };
        if fields.bytes(len).is_err() {
            return false;
        }
    }
    true
}

/// The fields of a record that are still to be read.
struct Fields<'a>(&'a [u8]);

impl<'a> Fields<'a> {
    fn bytes(&mut self, len: usize) -> Result<&'a [u8], Malformed> {
        let (field, rest) = self.0.split_at_checked(len).ok_or(TOO_SHORT)?;
        self.0 = rest;
        Ok(field)
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N], Malformed> {
        let (field, rest) = self.0.split_first_chunk::<N>().ok_or(TOO_SHORT)?;
        self.0 = rest;
        Ok(*field)
    }

    fn u16(&mut self) -> Result<u16, Malformed> {
        self.array().map(u16::from_le_bytes)
    }

    fn u32(&mut self) -> Result<u32, Malformed> {
        self.array().map(u32::from_le_bytes)
    }

    fn u64(&mut self) -> Result<u64, Malformed> {
        self.array().map(u64::from_le_bytes)
    }

    fn text(&mut self) -> Result<&'a str, Malformed> {
        let len = self.u32()? as usize;
        let text = self.bytes(len)?;
        str::from_utf8(text).map_err(|_| "a text in a record is not UTF-8")
    }

    fn name(&mut self) -> Result<String, Malformed> {
        let name = self.text()?;
        if name.len() > NAME_LIMIT {
            return Err("a name in a record is longer than 1024 bytes");
        }
        Ok(name.to_owned())
    }
}
