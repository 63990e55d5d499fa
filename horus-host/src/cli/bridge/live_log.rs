use std::fs::{self, File};
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use horus_host::log::msg::Message;
use horus_host::log::{LogError, LogWriter};

/// A log of what comes over topics. A file that is there already is replaced by the first message, not before.
///
/// It has its own name from the start: what was flushed survives a crash.
pub struct LiveLog {
    path: PathBuf,
    writer: Option<LogWriter<BufWriter<File>>>,
}

impl LiveLog {
    pub fn new(path: &Path) -> Result<Self, LogError> {
        let writer = match path.exists() {
            true => None,
            false => Some(LogWriter::create(path)?),
        };
        Ok(Self {
            path: path.to_owned(),
            writer,
        })
    }

    pub fn write<M: Message>(&mut self, topic: &str, stamp_ns: u64, message: &M) -> Result<(), LogError> {
        let writer = match &mut self.writer {
            Some(writer) => writer,
            none => none.insert(LogWriter::create(&self.path)?),
        };
        writer.write(topic, stamp_ns, message)
    }

    /// Writes index and footer.
    pub fn finish(self) -> Result<(), LogError> {
        self.writer.map_or(Ok(()), |writer| writer.finish().map(|_| ()))
    }

    /// Leaves things as they were: nothing was written.
    pub fn discard(self) {
        if self.writer.is_some() {
            drop(self.writer);
            let _ = fs::remove_file(&self.path);
        }
    }
}
