use std::{
    collections::{BTreeMap, btree_map::Entry},
    fs::File,
    io::{BufWriter, Write},
    path::Path,
};

use mcap::{
    Compression, WriteOptions,
    records::{MessageHeader, Metadata},
    write::NoSeek,
};

use super::{
    LogError, MESSAGE_ENCODING, RECORD_LIMIT, SCHEMA_ENCODING, cdr::CdrWriter, msg::Message,
    qos::offered_qos_profiles,
};

/// Messages between two flushes, unless [`LogWriter::set_flush_interval`] says otherwise.
pub const DEFAULT_FLUSH_INTERVAL: u32 = 256;

/// A chunk is closed at the first message after this many bytes.
const CHUNK_SIZE: u64 = 1 << 20;

/// Longest payload: what is left of the limit of readers when it shares a chunk with others.
const PAYLOAD_LIMIT: usize = RECORD_LIMIT - 2 * CHUNK_SIZE as usize;

/// Writes an MCAP log that ROS 2 tools and viewers read.
///
/// The log is written in place, front to back: what was flushed can be read after a crash, up to
/// the last flush, although the file then has no index. The same calls give the same bytes, on
/// every machine. A log dropped without [`finish`](Self::finish) is finished as far as possible,
/// but nobody hears of errors.
pub struct LogWriter<W: Write> {
    container: mcap::Writer<NoSeek<W>>,
    channels: BTreeMap<String, Channel>,
    payload: CdrWriter,
    flush_interval: u32,
    unflushed: u32,
}

/// What the writer knows of a topic.
struct Channel {
    id: u16,
    type_name: &'static str,
    sequence: u32,
}

impl LogWriter<BufWriter<File>> {
    /// Creates the log file `path`, replacing what is there.
    ///
    /// # Errors
    /// [`LogError::Create`] names the path if the file cannot be created; [`LogError::Write`].
    pub fn create(path: &Path) -> Result<Self, LogError> {
        let file = File::create(path).map_err(|source| LogError::Create {
            path: path.to_owned(),
            source,
        })?;
        Self::new(BufWriter::new(file))
    }
}

impl<W: Write> LogWriter<W> {
    /// Starts a log in `sink`.
    ///
    /// # Errors
    /// [`LogError::Write`].
    pub fn new(sink: W) -> Result<Self, LogError> {
        let container = WriteOptions::new()
            .profile("ros2")
            .library(concat!("horus-host ", env!("CARGO_PKG_VERSION")))
            .compression(Some(Compression::Zstd))
            // The default is one thread per core, and their number shapes the compressed bytes.
            .compression_threads(0)
            .chunk_size(Some(CHUNK_SIZE))
            // Chunks are made in memory and appended whole: a crash leaves no half-written header.
            .disable_seeking(true)
            .create(NoSeek::new(sink))
            .map_err(write_error)?;
        Ok(Self {
            container,
            channels: BTreeMap::new(),
            payload: CdrWriter::new(),
            flush_interval: DEFAULT_FLUSH_INTERVAL,
            unflushed: 0,
        })
    }

    /// Flushes after every `messages` messages from now on; 0 leaves flushing to the caller.
    /// Smaller chunks survive a crash sooner and compress less well.
    pub fn set_flush_interval(&mut self, messages: u32) {
        self.flush_interval = messages;
    }

    /// Writes a message to `topic`, logged and published at `stamp_ns`.
    ///
    /// # Errors
    /// [`LogError::Encode`], [`LogError::MessageTooLong`] and [`LogError::TopicType`] leave the log
    /// as it was; after [`LogError::Write`] it takes nothing more.
    pub fn write<M: Message>(&mut self, topic: &str, stamp_ns: u64, message: &M) -> Result<(), LogError> {
        self.payload.restart();
        message.encode(&mut self.payload);
        let payload = self.payload.finish().map_err(|source| LogError::Encode {
            topic: topic.to_owned(),
            source,
        })?;
        if payload.len() > PAYLOAD_LIMIT {
            return Err(LogError::MessageTooLong {
                topic: topic.to_owned(),
                len: payload.len(),
                limit: PAYLOAD_LIMIT,
            });
        }
        let channel = match self.channels.entry(topic.to_owned()) {
            Entry::Occupied(known) => known.into_mut(),
            Entry::Vacant(new) => {
                new.insert(add_channel::<M, W>(&mut self.container, topic).map_err(write_error)?)
            }
        };
        if channel.type_name != M::TYPE {
            return Err(LogError::TopicType {
                topic: topic.to_owned(),
                logged: channel.type_name.to_owned(),
                given: M::TYPE,
            });
        }
        let header = MessageHeader {
            channel_id: channel.id,
            sequence: channel.sequence,
            log_time: stamp_ns,
            publish_time: stamp_ns,
        };
        self.container
            .write_to_known_channel(&header, payload)
            .map_err(write_error)?;
        channel.sequence = channel.sequence.wrapping_add(1);
        self.unflushed += 1;
        if self.flush_interval > 0 && self.unflushed >= self.flush_interval {
            self.flush()?;
        }
        Ok(())
    }

    /// Writes a metadata record, and flushes.
    ///
    /// # Errors
    /// [`LogError::Write`].
    pub fn metadata(&mut self, name: &str, values: BTreeMap<String, String>) -> Result<(), LogError> {
        let record = Metadata {
            name: name.to_owned(),
            metadata: values,
        };
        self.container.write_metadata(&record).map_err(write_error)?;
        self.flush()
    }

    /// Closes the current chunk and hands everything to the system: what was written so far
    /// survives a crash of this process.
    ///
    /// # Errors
    /// [`LogError::Write`].
    pub fn flush(&mut self) -> Result<(), LogError> {
        self.unflushed = 0;
        self.container.flush().map_err(write_error)
    }

    /// Writes index and footer, flushes, and returns the sink.
    ///
    /// # Errors
    /// [`LogError::Write`].
    pub fn finish(mut self) -> Result<W, LogError> {
        self.container.finish().map_err(write_error)?;
        let mut sink = self.container.into_inner().into_inner();
        sink.flush().map_err(|error| write_error(error.into()))?;
        Ok(sink)
    }
}

/// Adds the channel of a topic, and its schema where it is new.
fn add_channel<M: Message, W: Write>(
    container: &mut mcap::Writer<NoSeek<W>>,
    topic: &str,
) -> mcap::McapResult<Channel> {
    let schema = container.add_schema(M::TYPE, SCHEMA_ENCODING, M::definition().as_bytes())?;
    let metadata = BTreeMap::from([("offered_qos_profiles".to_owned(), offered_qos_profiles(topic))]);
    let id = container.add_channel(schema, topic, MESSAGE_ENCODING, &metadata)?;
    Ok(Channel {
        id,
        type_name: M::TYPE,
        sequence: 0,
    })
}

fn write_error(source: mcap::McapError) -> LogError {
    LogError::Write { source }
}
