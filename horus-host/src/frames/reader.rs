use std::io::{self, ErrorKind, Read};

use horus_core::frames::{Frame, FrameHeader, Unreadable, VERSION};

use super::StreamedTick;
use super::assembler::Assembler;
use super::order::{Order, Sequence};
use super::parser::{Found, FrameParser};
use super::problem::{ProblemKind, Problems};
use crate::lockstep::LockstepConfig;

/// Bytes that are read at once.
const BLOCK: usize = 4096;

/// Reads the ticks of a stream of frames.
///
/// Frames must come in order. A gap, or anything damaged that leaves one, drops ticks up to the
/// next key tick. A frame that comes late is dropped, unless the frame after it continues *it*: then
/// the sender has started over.
#[derive(Debug)]
pub struct StreamReader<R> {
    source: R,
    is_at_end: bool,
    parser: FrameParser,
    frames: FrameReader,
}

/// What becomes of frames, one after the other.
#[derive(Debug)]
struct FrameReader {
    sequence: Sequence,
    /// A late frame that may be the first after a restart.
    held: Option<HeldFrame>,
    assembler: Assembler,
    problems: Problems,
    frames: u64,
}

#[derive(Debug)]
struct HeldFrame {
    at: u64,
    header: FrameHeader,
    payload: Vec<u8>,
}

impl<R: Read> StreamReader<R> {
    /// Reads from `source`, maps of up to [`LockstepConfig::MOST_CELLS`] cells.
    pub fn new(source: R) -> Self {
        Self::with_cell_limit(source, LockstepConfig::MOST_CELLS as usize)
    }

    /// Reads from `source`, maps of up to `most_cells` cells: up to four bytes per cell are
    /// allocated.
    pub fn with_cell_limit(source: R, most_cells: usize) -> Self {
        Self {
            source,
            is_at_end: false,
            parser: FrameParser::default(),
            frames: FrameReader {
                sequence: Sequence::default(),
                held: None,
                assembler: Assembler::new(most_cells),
                problems: Problems::default(),
                frames: 0,
            },
        }
    }

    /// The next tick that arrived whole; `None` at the end of the source.
    ///
    /// # Errors
    /// What the source says, but for interruptions, which are tried again. Reading may go on then.
    pub fn next_tick(&mut self) -> io::Result<Option<StreamedTick>> {
        loop {
            let frames = &mut self.frames;
            match self.parser.next(self.is_at_end) {
                Found::Frame { at, header, payload } => {
                    if let Some(tick) = frames.frame(at, header, payload) {
                        return Ok(Some(tick));
                    }
                }
                Found::Corrupt { at } => frames.problems.add(ProblemKind::Corrupt, 1, at),
                Found::Truncated { at } => frames.problems.add(ProblemKind::Truncated, 1, at),
                Found::Nothing if self.is_at_end => {
                    frames.end(self.parser.position());
                    return Ok(None);
                }
                Found::Nothing => self.read()?,
            }
        }
    }

    /// What was wrong with the stream so far.
    pub fn problems(&self) -> &Problems {
        &self.frames.problems
    }

    /// Ticks that began and were not yielded, so far.
    pub fn skipped_ticks(&self) -> u64 {
        self.frames.assembler.skipped_ticks()
    }

    /// Whole frames so far.
    pub fn frames(&self) -> u64 {
        self.frames.frames
    }

    /// Bytes so far.
    pub fn bytes(&self) -> u64 {
        self.parser.position()
    }

    /// Bytes outside of whole frames so far: text, and what is left of damaged frames.
    pub fn bytes_outside(&self) -> u64 {
        self.parser.outside()
    }

    fn read(&mut self) -> io::Result<()> {
        let mut block = [0; BLOCK];
        match self.source.read(&mut block) {
            Ok(0) => self.is_at_end = true,
            Ok(n) => self.parser.push(block.get(..n).unwrap_or_default()),
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
        Ok(())
    }
}

impl FrameReader {
    /// Puts a frame in its place.
    fn frame(&mut self, at: u64, header: FrameHeader, payload: &[u8]) -> Option<StreamedTick> {
        self.frames += 1;
        let order = self.sequence.order(header.sequence);
        let held = self.held.take();
        if order == Order::Late {
            let follows = |held: &HeldFrame| held.header.sequence.wrapping_add(1) == header.sequence;
            let Some(first) = held.as_ref().filter(|held| follows(held)) else {
                self.drop_held(held);
                self.held = Some(HeldFrame {
                    at,
                    header,
                    payload: payload.to_vec(),
                });
                return None;
            };
            self.problems.add(ProblemKind::Restarted, 1, first.at);
            self.assembler.lose();
            // A tick cannot end with the first frame.
            self.apply(first.at, first.header, &first.payload);
        } else {
            self.drop_held(held);
        }
        match order {
            Order::First if header.sequence != 0 => self.problems.add(ProblemKind::JoinedLate, 1, at),
            Order::Gap(frames) => {
                self.problems.add(ProblemKind::Missing, frames.into(), at);
                self.assembler.lose();
            }
            _ => {}
        }
        self.sequence.follow(header.sequence);
        self.apply(at, header, payload)
    }

    fn apply(&mut self, at: u64, header: FrameHeader, payload: &[u8]) -> Option<StreamedTick> {
        let problem = if header.version != VERSION {
            ProblemKind::UnknownVersion
        } else {
            match Frame::read(header.kind, payload) {
                Ok(frame) => return self.assembler.apply(&frame, at, &mut self.problems),
                // A newer sender: the frames that are known still make sense without it.
                Err(Unreadable::UnknownKind) => {
                    self.problems.add(ProblemKind::UnknownKind, 1, at);
                    return None;
                }
                Err(Unreadable::Malformed) => ProblemKind::Malformed,
            }
        };
        self.problems.add(problem, 1, at);
        self.assembler.lose();
        None
    }

    fn drop_held(&mut self, held: Option<HeldFrame>) {
        if let Some(held) = held {
            self.problems.add(ProblemKind::OutOfOrder, 1, held.at);
        }
    }

    /// The stream ended after so many bytes.
    fn end(&mut self, at: u64) {
        let held = self.held.take();
        self.drop_held(held);
        if self.assembler.is_in_tick() {
            self.problems.add(ProblemKind::Truncated, 1, at);
            self.assembler.lose();
        }
    }
}
