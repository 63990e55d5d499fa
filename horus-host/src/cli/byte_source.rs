use std::fs::File;
use std::io::{self, ErrorKind, IsTerminal, Read, stdin};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel};
use std::thread;
use std::time::Duration;

use anyhow::Context;

/// How soon a request to stop is noticed.
const PATIENCE: Duration = Duration::from_millis(100);
/// Bytes that are read at once, and how many such blocks wait at most.
const BLOCK: usize = 4096;
const BLOCKS: usize = 64;

/// Bytes from a file, standard input or a serial device, read by a thread of their own, so that
/// Ctrl-C ends the reading also where no bytes come.
pub struct ByteSource {
    blocks: Receiver<io::Result<Vec<u8>>>,
    block: io::Cursor<Vec<u8>>,
    is_stopped: Arc<AtomicBool>,
    is_serial: bool,
}

impl ByteSource {
    /// Opens `path`; `-` is standard input. What is no serial device is read as a file.
    pub fn open(path: &Path, baud: u32) -> anyhow::Result<Self> {
        let name = path.display();
        let (reader, is_serial): (Box<dyn Read + Send>, bool) = if path == Path::new("-") {
            (Box::new(stdin()), false)
        } else if let Some(device) = serial(path, baud).with_context(|| format!("cannot open {name}"))? {
            (device, true)
        } else {
            let file = File::open(path).with_context(|| format!("cannot open {name}"))?;
            (Box::new(file), false)
        };
        let is_stopped = Arc::new(AtomicBool::new(false));
        let stop = Arc::clone(&is_stopped);
        ctrlc::set_handler(move || stop.store(true, Ordering::Relaxed)).context("cannot watch for Ctrl-C")?;
        let (sender, blocks) = sync_channel(BLOCKS);
        thread::spawn(move || pump(reader, &sender));
        Ok(Self {
            blocks,
            block: io::Cursor::default(),
            is_stopped,
            is_serial,
        })
    }

    /// The source is a serial device: what was sent before it was opened is gone.
    pub fn is_serial(&self) -> bool {
        self.is_serial
    }

    /// Whether the user has asked to stop; reading then fails.
    pub fn stop_flag(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.is_stopped)
    }
}

impl Read for ByteSource {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        loop {
            let n = self.block.read(buffer)?;
            if n > 0 {
                return Ok(n);
            }
            if self.is_stopped.load(Ordering::Relaxed) {
                return Err(io::Error::other("stopped"));
            }
            match self.blocks.recv_timeout(PATIENCE) {
                Ok(block) => self.block = io::Cursor::new(block?),
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => return Ok(0),
            }
        }
    }
}

/// A serial device, 8N1 and raw; `None` if the file is none.
fn serial(path: &Path, baud: u32) -> anyhow::Result<Option<Box<dyn Read + Send>>> {
    if !may_be_serial(path) {
        return Ok(None);
    }
    let name = path.to_str().context("the name is not UTF-8")?;
    match serialport::new(name, baud).timeout(PATIENCE).open() {
        Ok(port) => Ok(Some(Box::new(port))),
        // A device like /dev/null.
        Err(_) if File::open(path).is_ok_and(|file| !file.is_terminal()) => Ok(None),
        Err(error) => Err(error.into()),
    }
}

#[cfg(unix)]
fn may_be_serial(path: &Path) -> bool {
    use std::os::unix::fs::FileTypeExt;
    path.metadata()
        .is_ok_and(|file| file.file_type().is_char_device())
}

#[cfg(not(unix))]
fn may_be_serial(path: &Path) -> bool {
    !path.exists() // a port like COM3 is no file
}

/// Hands blocks on until the source ends or nobody listens.
fn pump(mut reader: impl Read, sender: &SyncSender<io::Result<Vec<u8>>>) {
    let mut block = [0; BLOCK];
    loop {
        let message = match reader.read(&mut block) {
            Ok(0) => return,
            Ok(n) => Ok(block.get(..n).unwrap_or_default().to_vec()),
            Err(error) if matches!(error.kind(), ErrorKind::Interrupted | ErrorKind::TimedOut) => continue,
            Err(error) => Err(error),
        };
        let is_last = message.is_err();
        if sender.send(message).is_err() || is_last {
            return;
        }
    }
}
