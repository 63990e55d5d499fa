use std::fmt;

use serde::Serialize;

use super::payload::{self, PayloadDifference};
use crate::log::{LogMessage, ReadEnd};

/// What comparing two logs found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    /// Whether both logs hold the same messages and both, or neither, were finished.
    pub equal: bool,
    /// How the first log ended.
    pub end_a: ReadEnd,
    /// How the second log ended.
    pub end_b: ReadEnd,
    /// Every topic with a message in either log, by name.
    pub topics: Vec<TopicComparison>,
}

/// What comparing one topic of two logs found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TopicComparison {
    /// The topic.
    pub topic: String,
    /// Floats and known cells at most this far apart are equal.
    pub tolerance: f64,
    /// Messages in the first log.
    pub messages_a: u64,
    /// Messages in the second log.
    pub messages_b: u64,
    /// Message pairs that differ, and messages without a partner.
    pub differing_messages: u64,
    /// Cells that differ, over all pairs of grids of equal size.
    pub differing_cells: u64,
    /// The first difference; `None` if the topic is equal.
    pub first: Option<Difference>,
}

/// One difference between two logs, within a topic.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Difference {
    /// Index of the message within its topic, from 0.
    pub message: u64,
    /// Log time of the message in the first log (in the second, where the first has none), ns.
    pub stamp_ns: u64,
    /// What differs: a field (`info.width`, `ranges[17]`, `data`), `type`, `log time`, `payload`
    /// for bytes we cannot decode, or `message` where one log has no such message.
    pub field: String,
    /// The cell (gx, gy) where a cell of a grid differs.
    pub cell: Option<[u64; 2]>,
    /// The value in the first log.
    pub a: String,
    /// The value in the second log.
    pub b: String,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "message {} at {} ns: ", self.message, self.stamp_ns)?;
        write!(f, "{}", self.field)?;
        if let Some([gx, gy]) = self.cell {
            write!(f, " of cell ({gx}, {gy})")?;
        }
        write!(f, " is {} against {}", self.a, self.b)
    }
}

impl TopicComparison {
    /// Whether both logs hold the same messages of this topic.
    pub fn is_equal(&self) -> bool {
        self.differing_messages == 0
    }

    pub(super) fn new(topic: String, tolerance: f64) -> Self {
        Self {
            topic,
            tolerance,
            messages_a: 0,
            messages_b: 0,
            differing_messages: 0,
            differing_cells: 0,
            first: None,
        }
    }

    /// Adds the next message of each log, at least one of which is there; whether they differ.
    pub(super) fn add(&mut self, a: Option<&LogMessage>, b: Option<&LogMessage>) -> bool {
        let Some(present) = a.or(b) else { return false };
        let message = self.messages_a.max(self.messages_b);
        self.messages_a += u64::from(a.is_some());
        self.messages_b += u64::from(b.is_some());
        let (difference, cells) = match (a, b) {
            (Some(a), Some(b)) => pair_difference(a, b, self.tolerance),
            _ => {
                let word = |message: Option<_>| match message {
                    Some(_) => "present",
                    None => "missing",
                };
                (Some(PayloadDifference::new("message", word(a), word(b))), 0)
            }
        };
        self.differing_cells += cells;
        let Some(difference) = difference else {
            return false;
        };
        self.differing_messages += 1;
        self.first.get_or_insert(Difference {
            message,
            stamp_ns: present.log_time_ns,
            field: difference.field,
            cell: difference.cell,
            a: difference.a,
            b: difference.b,
        });
        true
    }
}

/// The first difference of two messages, and the number of differing cells.
fn pair_difference(a: &LogMessage, b: &LogMessage, tolerance: f64) -> (Option<PayloadDifference>, u64) {
    let (of_a, of_b) = (&a.channel, &b.channel);
    if (&of_a.type_name, &of_a.encoding) != (&of_b.type_name, &of_b.encoding) {
        let kind = |message: &LogMessage| {
            let channel = &message.channel;
            format!("{} ({})", channel.type_name, channel.encoding)
        };
        return (Some(PayloadDifference::new("type", kind(a), kind(b))), 0);
    }
    let (content, cells) = payload::difference(of_a, &a.payload, &b.payload, tolerance);
    let time = (a.log_time_ns != b.log_time_ns)
        .then(|| PayloadDifference::new("log time", a.log_time_ns, b.log_time_ns));
    (time.or(content), cells)
}
