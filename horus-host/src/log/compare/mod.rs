//! Comparing two logs: topic by topic, message by message, field by field, cell by cell.
mod cells;
mod payload;
mod summary;

use std::{
    collections::{BTreeMap, BTreeSet},
    fs::File,
    io::BufReader,
    path::Path,
};

use super::{LogEntry, LogError, LogMessage, LogReader, ReadEnd};

pub use summary::{Comparison, Difference, TopicComparison};

/// Compares the messages of two logs.
///
/// Within a topic the messages are paired in order and compared by type, log time and content;
/// between topics the order does not matter. Content means decoded fields (floats by their bits),
/// so padding and byte order do not; payloads we cannot decode are compared as bytes. Metadata
/// records, publish times and chunk boundaries are not compared. A truncated log is compared as
/// far as it goes, and differs from a log that is complete.
///
/// # Errors
/// [`LogError::InFile`] names the log that cannot be read, and says why.
///
/// # Complexity
/// Reads each log once per topic and once more, and holds one message of each in memory.
pub fn compare(a: &Path, b: &Path) -> Result<Comparison, LogError> {
    compare_with(a, b, &BTreeMap::new(), &mut |_| Ok::<(), LogError>(()))
}

/// Two messages that differ, the next of their topic in each log; one may be missing.
#[derive(Debug, Clone, Copy)]
pub struct DifferingPair<'a> {
    /// The one in the first log.
    pub a: Option<&'a LogMessage>,
    /// The one in the second log.
    pub b: Option<&'a LogMessage>,
}

/// Compares as [`compare`] does, but floats and known cells may differ by the tolerance of their
/// topic; hands on every pair that differs. Unknown cells equal unknown cells only.
///
/// # Errors
/// As [`compare`], and what `sink` returns.
pub fn compare_with<E: From<LogError>>(
    a: &Path,
    b: &Path,
    tolerances: &BTreeMap<String, f64>,
    sink: &mut dyn FnMut(DifferingPair) -> Result<(), E>,
) -> Result<Comparison, E> {
    let mut topics = BTreeSet::new();
    let end_a = survey(a, &mut topics)?;
    let end_b = survey(b, &mut topics)?;
    let topics = topics
        .into_iter()
        .map(|topic| {
            let tolerance = tolerances.get(&topic).copied().unwrap_or(0.0);
            compare_topic((a, b), topic, tolerance, sink)
        })
        .collect::<Result<Vec<_>, _>>()?;
    let both_end_alike = matches!(end_a, ReadEnd::Complete) == matches!(end_b, ReadEnd::Complete);
    Ok(Comparison {
        equal: both_end_alike && topics.iter().all(TopicComparison::is_equal),
        end_a,
        end_b,
        topics,
    })
}

/// Adds the topics with messages in the log at `path`, and tells how it ends.
fn survey(path: &Path, topics: &mut BTreeSet<String>) -> Result<ReadEnd, LogError> {
    let in_file = |error| in_file(path, error);
    let mut reader = LogReader::open(path).map_err(in_file)?;
    for entry in &mut reader {
        if let LogEntry::Message(message) = entry.map_err(in_file)?
            && !topics.contains(message.topic())
        {
            topics.insert(message.topic().to_owned());
        }
    }
    // Without an error the reader has always reached an end.
    Ok(reader.end().unwrap_or(ReadEnd::Complete))
}

fn compare_topic<E: From<LogError>>(
    (a, b): (&Path, &Path),
    topic: String,
    tolerance: f64,
    sink: &mut dyn FnMut(DifferingPair) -> Result<(), E>,
) -> Result<TopicComparison, E> {
    let mut messages_a = TopicReader::open(a, &topic)?;
    let mut messages_b = TopicReader::open(b, &topic)?;
    let mut result = TopicComparison::new(topic.clone(), tolerance);
    loop {
        let (a, b) = (messages_a.next()?, messages_b.next()?);
        if a.is_none() && b.is_none() {
            return Ok(result);
        }
        if result.add(a.as_ref(), b.as_ref()) {
            sink(DifferingPair {
                a: a.as_ref(),
                b: b.as_ref(),
            })?;
        }
    }
}

/// The messages of one topic of a log.
struct TopicReader<'a> {
    path: &'a Path,
    topic: &'a str,
    reader: LogReader<BufReader<File>>,
}

impl<'a> TopicReader<'a> {
    fn open(path: &'a Path, topic: &'a str) -> Result<Self, LogError> {
        Ok(Self {
            path,
            topic,
            reader: LogReader::open(path).map_err(|error| in_file(path, error))?,
        })
    }

    fn next(&mut self) -> Result<Option<LogMessage>, LogError> {
        for entry in &mut self.reader {
            match entry {
                Ok(LogEntry::Message(message)) if message.topic() == self.topic => {
                    return Ok(Some(message));
                }
                Ok(_) => {}
                Err(error) => return Err(in_file(self.path, error)),
            }
        }
        Ok(None)
    }
}

fn in_file(path: &Path, error: LogError) -> LogError {
    match error {
        // This one names the file itself.
        LogError::Open { .. } => error,
        error => LogError::InFile {
            path: path.to_owned(),
            source: Box::new(error),
        },
    }
}
