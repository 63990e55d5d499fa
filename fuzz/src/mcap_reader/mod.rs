//! Target `mcap_reader`: whatever the bytes are, reading ends in an error or yields messages, in
//! bounded memory, and does not depend on how the source hands out its bytes.

mod build;
mod samples;

pub use build::{BuiltLog, Checksum, Entry, Payload, Record, Text};

use std::io::Read;

use arbitrary::Arbitrary;
use horus_host::log::msg::{Costmap, Grid, LaserScan, Message, OccupancyGrid, Path, TFMessage};
use horus_host::log::{LogEntry, LogReader, ReadEnd};

use crate::damage::Damage;
use crate::memory::peak_of;

/// The reader's record limit.
const LIMIT: usize = 64 << 10;

/// A log.
#[derive(Clone, Debug, Arbitrary)]
pub enum ReaderCase {
    /// Any bytes.
    Bytes(Vec<u8>),
    /// Any bytes after the magic ones.
    AfterMagic(Vec<u8>),
    /// Records one after the other, right or wrong.
    Built(BuiltLog),
    /// A good log that was damaged.
    Damaged {
        /// Which one.
        sample: u8,
        /// What happened to it.
        damages: Vec<Damage>,
        /// Bytes handed out at once, where reading is repeated.
        at_once: u8,
    },
}

/// Reads a case; panics where the reader breaks its promises.
pub fn run(case: &ReaderCase) {
    let mut at_once = 7;
    let bytes = match case {
        ReaderCase::Bytes(bytes) => bytes.clone(),
        ReaderCase::AfterMagic(bytes) => [mcap::MAGIC, bytes].concat(),
        ReaderCase::Built(log) => log.bytes(),
        ReaderCase::Damaged {
            sample,
            damages,
            at_once: n,
        } => {
            at_once = usize::from(*n) + 1;
            let mut bytes = samples::log(*sample).to_vec();
            damages.iter().take(8).for_each(|damage| damage.apply(&mut bytes));
            bytes
        }
    };
    let peak = peak_of(|| {
        let _count = LogReader::with_record_limit(&bytes[..], LIMIT).count();
    });
    let bound = 8 * LIMIT + 16 * bytes.len();
    assert!(peak <= bound, "reading {} bytes took {peak}", bytes.len());

    let (entries, end) = read(&bytes[..]);
    let (dribbled, dribbled_end) = read(Dribble {
        bytes: &bytes,
        at_once,
    });
    assert_eq!(dribbled, entries, "entries, {at_once} bytes at once");
    assert_eq!(dribbled_end, end, "end, {at_once} bytes at once");
    for entry in &entries {
        if let LogEntry::Message(message) = entry {
            decode(&message.payload);
            let _ = message.decode::<LaserScan>();
        }
    }
}

/// Every entry, and how it ended; an error as its text.
fn read(source: impl Read) -> (Vec<LogEntry>, Result<ReadEnd, String>) {
    let mut reader = LogReader::with_record_limit(source, LIMIT);
    let mut entries = Vec::new();
    while let Some(entry) = reader.next() {
        match entry {
            Ok(entry) => entries.push(entry),
            Err(error) => {
                assert!(reader.next().is_none(), "nothing comes after an error");
                assert!(reader.end().is_none(), "an error is no end");
                return (entries, Err(error.to_string()));
            }
        }
    }
    let end = reader.end().expect("it ended without an error");
    (entries, Ok(end))
}

/// A source that hands out few bytes at once.
struct Dribble<'a> {
    bytes: &'a [u8],
    at_once: usize,
}

impl Read for Dribble<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let n = self.at_once.min(buffer.len());
        self.bytes.read(&mut buffer[..n])
    }
}

/// A payload as every message type.
fn decode(payload: &[u8]) {
    decode_as::<OccupancyGrid>(payload);
    decode_as::<Costmap>(payload);
    decode_as::<Grid>(payload);
    decode_as::<LaserScan>(payload);
    decode_as::<Path>(payload);
    decode_as::<TFMessage>(payload);
}

/// Decoding takes memory in proportion to the payload, and what was decoded survives a round trip.
fn decode_as<M: Message>(payload: &[u8]) {
    let mut decoded = None;
    let peak = peak_of(|| decoded = M::from_payload(payload).ok());
    let (len, name) = (payload.len(), M::TYPE);
    assert!(
        peak <= 16 * len + 1024,
        "decoding {len} bytes as {name} took {peak}"
    );
    let Some(Ok(written)) = decoded.map(|message| message.to_payload()) else {
        return;
    };
    let again = M::from_payload(&written).expect("what was written can be read");
    let again = again.to_payload().expect("it could be written before");
    assert!(again == written, "a {name} does not survive a round trip");
}
