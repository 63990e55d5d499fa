use std::{
    collections::HashMap,
    fs::File,
    io::{BufReader, Read},
    path::Path,
    sync::Arc,
};

use mcap::{
    MAGIC, McapError,
    records::op,
    sans_io::{LinearReadEvent, LinearReader, LinearReaderOptions},
};

use super::{
    LogChannel, LogEntry, LogError, LogMessage, RECORD_LIMIT, ReadEnd,
    chunk::{ChunkError, ChunkReader},
    record::{self, Malformed, PREFIX_LEN},
};

/// Most bytes asked of the source at once; a record longer than this is read in several steps, so
/// a damaged length costs no memory the file does not fill.
const READ_SIZE: usize = 64 << 10;

/// Reads the messages and metadata records of an MCAP log in file order, from any source.
///
/// An iterator of [`LogEntry`]; after the first error it yields nothing more. A log that stops in
/// the middle is no error: every entry up to the last whole record comes out, and [`end`](
/// Self::end) then says [`ReadEnd::Truncated`]. A chunk is one record: its messages come out if it
/// is whole and its checksum is right. Data-section and chunk checksums are verified.
///
/// Memory: a few times the record limit at most, whatever the file says.
pub struct LogReader<R> {
    source: R,
    container: LinearReader,
    chunk: ChunkReader,
    schemas: HashMap<u16, String>,
    channels: HashMap<u16, Arc<LogChannel>>,
    /// Bytes received from the source.
    received: u64,
    /// Start of the record (or chunk) whose entries are being yielded.
    current: u64,
    /// End of that record.
    next: u64,
    state: State,
}

/// How far reading has come.
enum State {
    Reading,
    Failed,
    Ended(ReadEnd),
}

impl LogReader<BufReader<File>> {
    /// Opens the log at `path`.
    ///
    /// # Errors
    /// [`LogError::Open`]. That the file is empty or no MCAP file turns up at the first entry.
    pub fn open(path: &Path) -> Result<Self, LogError> {
        let file = File::open(path).map_err(|source| LogError::Open {
            path: path.to_owned(),
            source,
        })?;
        Ok(Self::new(BufReader::new(file)))
    }
}

impl<R: Read> LogReader<R> {
    /// Reads from `source`, with records and chunks of at most [`RECORD_LIMIT`] bytes.
    pub fn new(source: R) -> Self {
        Self::with_record_limit(source, RECORD_LIMIT)
    }

    /// Reads from `source`; a record, or a chunk before or after decompression, of more than
    /// `limit` bytes is an error.
    pub fn with_record_limit(source: R, limit: usize) -> Self {
        let options = LinearReaderOptions::default()
            .with_emit_chunks(true)
            .with_validate_data_section_crc(true)
            .with_record_length_limit(limit);
        Self {
            source,
            container: LinearReader::new_with_options(options),
            chunk: ChunkReader::new(limit),
            schemas: HashMap::new(),
            channels: HashMap::new(),
            received: 0,
            current: 0,
            next: MAGIC.len() as u64,
            state: State::Reading,
        }
    }

    /// How the log ended; `None` until every entry has been read, and after an error.
    pub fn end(&self) -> Option<ReadEnd> {
        match self.state {
            State::Ended(end) => Some(end),
            State::Reading | State::Failed => None,
        }
    }

    /// The next entry, or how the log ended.
    fn advance(&mut self) -> Result<Result<LogEntry, ReadEnd>, LogError> {
        loop {
            if let Some(record) = self.chunk.next() {
                let offset = self.current;
                let (opcode, fields) = record.map_err(|source| LogError::Damaged { offset, source })?;
                let tables = (&mut self.schemas, &mut self.channels);
                match interpret(opcode, fields, tables, offset) {
                    Ok(Some(entry)) => return Ok(Ok(entry)),
                    Ok(None) => continue,
                    Err(what) => return Err(LogError::Malformed { offset, what }),
                }
            }
            let offset = self.next;
            match self.container.next_event() {
                None => return Ok(Err(ReadEnd::Complete)),
                Some(Ok(LinearReadEvent::ReadRequest(wanted))) => {
                    if !self.receive(wanted)? {
                        return self.truncated().map(Err);
                    }
                }
                Some(Ok(LinearReadEvent::Record { opcode, data })) => {
                    self.current = offset;
                    self.next = offset + (PREFIX_LEN + data.len()) as u64;
                    let malformed = |what| LogError::Malformed { offset, what };
                    if opcode == op::CHUNK {
                        self.chunk.open(data).map_err(|error| match error {
                            ChunkError::Mcap(source) => LogError::Damaged { offset, source },
                            ChunkError::Malformed(what) => malformed(what),
                        })?;
                        continue;
                    }
                    let tables = (&mut self.schemas, &mut self.channels);
                    if let Some(entry) = interpret(opcode, data, tables, offset).map_err(malformed)? {
                        return Ok(Ok(entry));
                    }
                }
                Some(Err(McapError::BadMagic)) if self.current == 0 => {
                    return Err(LogError::NotMcap);
                }
                // What a writer that patches lengths afterwards leaves behind in a crash.
                Some(Err(McapError::RecordTooLarge { len: u64::MAX, .. })) => {
                    return self.truncated().map(Err);
                }
                Some(Err(source)) => return Err(LogError::Damaged { offset, source }),
            }
        }
    }

    /// Gets up to `wanted` bytes from the source; `false` if it has no more.
    fn receive(&mut self, wanted: usize) -> Result<bool, LogError> {
        let buffer = self.container.insert(wanted.min(READ_SIZE));
        let received = loop {
            match self.source.read(buffer) {
                Ok(received) => break received,
                Err(error) if error.kind() == std::io::ErrorKind::Interrupted => {}
                Err(source) => {
                    let offset = self.received;
                    return Err(LogError::Read { offset, source });
                }
            }
        };
        if received > 0 {
            // No bytes would mean end of file to the container, which has an error for that only.
            self.container.notify_read(received);
            self.received += received as u64;
        }
        Ok(received > 0)
    }

    /// The state at an early end of the source.
    fn truncated(&self) -> Result<ReadEnd, LogError> {
        if self.received == 0 {
            return Err(LogError::Empty);
        }
        if self.received < MAGIC.len() as u64 {
            return Err(LogError::NotMcap);
        }
        Ok(ReadEnd::Truncated { offset: self.next })
    }
}

impl<R: Read> Iterator for LogReader<R> {
    type Item = Result<LogEntry, LogError>;

    fn next(&mut self) -> Option<Self::Item> {
        if !matches!(self.state, State::Reading) {
            return None;
        }
        match self.advance() {
            Ok(Ok(entry)) => Some(Ok(entry)),
            Ok(Err(end)) => {
                self.state = State::Ended(end);
                None
            }
            Err(error) => {
                self.state = State::Failed;
                Some(Err(error))
            }
        }
    }
}

/// Known schema names and channels, by id.
type Tables<'a> = (
    &'a mut HashMap<u16, String>,
    &'a mut HashMap<u16, Arc<LogChannel>>,
);

/// Notes schemas and channels; makes an entry of messages and metadata; passes over the rest.
fn interpret(
    opcode: u8,
    fields: &[u8],
    (schemas, channels): Tables,
    offset: u64,
) -> Result<Option<LogEntry>, Malformed> {
    match opcode {
        op::SCHEMA => {
            let schema = record::schema(fields)?;
            let known = schemas.entry(schema.id).or_insert_with(|| schema.name.clone());
            if *known != schema.name {
                return Err("a schema id is defined twice, differently");
            }
        }
        op::CHANNEL => {
            let record = record::channel(fields)?;
            let type_name = match record.schema_id {
                0 => String::new(),
                id => schemas
                    .get(&id)
                    .ok_or("a channel refers to a schema that was not defined")?
                    .clone(),
            };
            let channel = LogChannel {
                topic: record.topic,
                type_name,
                encoding: record.encoding,
            };
            let known = channels
                .entry(record.id)
                .or_insert_with(|| Arc::new(channel.clone()));
            if **known != channel {
                return Err("a channel id is defined twice, differently");
            }
        }
        op::MESSAGE => {
            let message = record::message(fields)?;
            let channel = channels
                .get(&message.channel_id)
                .ok_or("a message refers to a channel that was not defined")?;
            return Ok(Some(LogEntry::Message(LogMessage {
                channel: Arc::clone(channel),
                log_time_ns: message.log_time_ns,
                publish_time_ns: message.publish_time_ns,
                offset,
                payload: message.payload.to_vec(),
            })));
        }
        op::METADATA => {
            let (name, values) = record::metadata(fields)?;
            return Ok(Some(LogEntry::Metadata { name, values }));
        }
        _ => {}
    }
    Ok(None)
}
