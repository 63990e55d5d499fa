use horus_core::frames::{FrameHeader, MAX_FRAME, SYNC, Take};

/// Finds frames in bytes: sync word, plausible length, right checksum.
///
/// Holds at most one frame and one block of bytes that was pushed. After bytes that look like a
/// frame and are none, the search goes on one byte later, so that nothing behind a damaged length
/// is lost.
#[derive(Debug, Default)]
pub(super) struct FrameParser {
    buffer: Vec<u8>,
    /// Bytes of the buffer that are done with.
    used: usize,
    /// Where in the stream the buffer starts.
    offset: u64,
    /// A frame ended here or text followed it: what looks like a frame should be one.
    is_in_sync: bool,
    /// Bytes outside of frames.
    outside: u64,
}

/// What the parser found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Found<'a> {
    /// A frame with the right checksum.
    Frame {
        /// Where in the stream it starts.
        at: u64,
        header: FrameHeader,
        payload: &'a [u8],
    },
    /// Bytes that look like a frame and have a wrong length or checksum.
    Corrupt { at: u64 },
    /// A frame that the end of the stream cut off.
    Truncated { at: u64 },
    /// No more without more bytes.
    Nothing,
}

/// What stands at the parser's place.
enum Candidate {
    Frame(FrameHeader),
    Damaged,
    Incomplete,
}

impl FrameParser {
    /// Bytes outside of frames so far.
    pub fn outside(&self) -> u64 {
        self.outside
    }

    /// Bytes of the stream so far.
    pub fn position(&self) -> u64 {
        self.offset + self.buffer.len() as u64
    }

    /// Adds bytes. Call it when [`next`](Self::next) has found nothing.
    pub fn push(&mut self, bytes: &[u8]) {
        self.buffer.drain(..self.used);
        self.offset += self.used as u64;
        self.used = 0;
        self.buffer.extend_from_slice(bytes);
    }

    /// The next frame or damage; `is_end`: no bytes will follow.
    pub fn next(&mut self, is_end: bool) -> Found<'_> {
        loop {
            self.skip_to_sync(is_end);
            let at = self.offset + self.used as u64;
            match self.candidate() {
                Candidate::Frame(header) => {
                    let start = self.used + SYNC.len() + FrameHeader::LEN;
                    self.used += header.frame_len();
                    self.is_in_sync = true;
                    let payload = self
                        .buffer
                        .get(start..start + usize::from(header.payload_len))
                        .unwrap_or_default();
                    return Found::Frame { at, header, payload };
                }
                Candidate::Damaged => {
                    if self.step_over() {
                        return Found::Corrupt { at };
                    }
                }
                Candidate::Incomplete => {
                    if !is_end || self.rest().is_empty() {
                        return Found::Nothing;
                    }
                    if self.step_over() {
                        return Found::Truncated { at };
                    }
                }
            }
        }
    }

    fn rest(&self) -> &[u8] {
        self.buffer.get(self.used..).unwrap_or_default()
    }

    /// Skips what is no sync word. Without more bytes to come its first byte alone is none.
    fn skip_to_sync(&mut self, is_end: bool) {
        let rest = self.rest();
        let is_start = |i: usize| match rest.get(i + 1) {
            Some(second) => *second == SYNC[1],
            None => !is_end,
        };
        let skipped = (0..rest.len())
            .find(|i| rest[*i] == SYNC[0] && is_start(*i))
            .unwrap_or(rest.len());
        self.used += skipped;
        self.outside += skipped as u64;
    }

    fn candidate(&self) -> Candidate {
        let Some(after_sync) = self.rest().get(SYNC.len()..) else {
            return Candidate::Incomplete;
        };
        let Some(header) = FrameHeader::take(&mut Take::new(after_sync)) else {
            return Candidate::Incomplete;
        };
        if header.frame_len() > MAX_FRAME {
            return Candidate::Damaged;
        }
        let covered = FrameHeader::LEN + usize::from(header.payload_len);
        let Some((covered, after)) = after_sync.split_at_checked(covered) else {
            return Candidate::Incomplete;
        };
        match Take::new(after).u32() {
            None => Candidate::Incomplete,
            Some(crc) if crc == crc32fast::hash(covered) => Candidate::Frame(header),
            Some(_) => Candidate::Damaged,
        }
    }

    /// Goes on one byte later. Whether this is news: what follows a damaged place is searched
    /// without complaint up to the next frame.
    fn step_over(&mut self) -> bool {
        self.used += 1;
        self.outside += 1;
        std::mem::replace(&mut self.is_in_sync, false)
    }
}
