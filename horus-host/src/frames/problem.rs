use std::collections::BTreeMap;
use std::fmt;

use serde::Serialize;

/// What can be wrong with a stream.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ProblemKind {
    /// The stream's first frame is not the first that was sent.
    JoinedLate,
    /// A frame's checksum is wrong, or its length impossible. Counted once per place.
    Corrupt,
    /// The stream ended in the middle of a frame or a tick.
    Truncated,
    /// Frames that never came, by their sequence numbers.
    Missing,
    /// Frames that came late or twice.
    OutOfOrder,
    /// The sender's sequence numbers started over.
    Restarted,
    /// Frames of a format version this reader does not know.
    UnknownVersion,
    /// Frames of a kind this reader does not know.
    UnknownKind,
    /// Frames whose fields are not those of their kind, or cannot be.
    Malformed,
    /// Frames that do not fit the map or the frames before them.
    Inconsistent,
    /// Ticks after which the sender's map and the listener's differ.
    MapDiffers,
}

impl ProblemKind {
    /// The problem in words, for so many of them.
    fn sentence(self, count: u64) -> String {
        let things = |thing: &str| match count {
            1 => format!("1 {thing}"),
            _ => format!("{count} {thing}s"),
        };
        match self {
            Self::JoinedLate => "the beginning of the stream is missing".into(),
            Self::Corrupt => format!("the stream is damaged in {}", things("place")),
            Self::Truncated => "the stream ends in the middle of a tick".into(),
            Self::Missing => format!("{} never came", things("frame")),
            Self::OutOfOrder => format!("{} came late or twice", things("frame")),
            Self::Restarted => format!("the sender started over, {}", things("time")),
            Self::UnknownVersion => format!("{} of an unknown format version", things("frame")),
            Self::UnknownKind => format!("{} of an unknown kind", things("frame")),
            Self::Malformed => format!("{} with impossible contents", things("frame")),
            Self::Inconsistent => format!("{} that do not fit the frames before them", things("frame")),
            Self::MapDiffers => format!(
                "after {} the map differs from the sender's checksum",
                things("tick")
            ),
        }
    }
}

/// Problems of one kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Problem {
    /// How many.
    pub count: u64,
    /// Where in the stream the first was noticed, in bytes.
    pub first_at_byte: u64,
}

/// Everything that was wrong with a stream, by kind.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub struct Problems {
    kinds: BTreeMap<ProblemKind, Problem>,
}

impl Problems {
    /// True if nothing was wrong.
    pub fn is_empty(&self) -> bool {
        self.kinds.is_empty()
    }

    /// The problems of one kind.
    pub fn get(&self, kind: ProblemKind) -> Option<Problem> {
        self.kinds.get(&kind).copied()
    }

    /// The kinds there are, each with its problems.
    pub fn iter(&self) -> impl Iterator<Item = (ProblemKind, Problem)> + '_ {
        self.kinds.iter().map(|(kind, problem)| (*kind, *problem))
    }

    pub(super) fn add(&mut self, kind: ProblemKind, count: u64, at_byte: u64) {
        let problem = self.kinds.entry(kind).or_insert(Problem {
            count: 0,
            first_at_byte: at_byte,
        });
        problem.count = problem.count.saturating_add(count);
    }
}

impl fmt::Display for Problems {
    /// One sentence per kind and line.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, (kind, problem)) in self.iter().enumerate() {
            let newline = if i > 0 { "\n" } else { "" };
            let sentence = kind.sentence(problem.count);
            write!(f, "{newline}{sentence} (first at byte {})", problem.first_at_byte)?;
        }
        Ok(())
    }
}
