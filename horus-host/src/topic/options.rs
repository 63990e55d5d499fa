use std::time::Duration;

/// How a topic delivers. Publishers and subscribers of a topic must agree on `buffer` and `reliable`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TopicOptions {
    /// Messages that wait for a subscriber.
    pub buffer: usize,
    /// A publisher waits for a subscriber whose buffer is full, for `patience` at most, instead of
    /// replacing the oldest message in it.
    pub reliable: bool,
    /// How long it waits; then the message is lost for that subscriber and `send` is an error.
    pub patience: Duration,
    /// Elements that messages of a [`SliceTopic`](super::SliceTopic) are expected to have. Longer ones
    /// are sent as well, but those that nobody has read yet when the publisher ends are lost.
    pub expected_len: usize,
}

impl Default for TopicOptions {
    /// Eight messages; the oldest is replaced.
    fn default() -> Self {
        Self {
            buffer: 8,
            reliable: false,
            patience: Duration::from_secs(2),
            expected_len: 1,
        }
    }
}

impl TopicOptions {
    /// Nothing is lost while subscribers live.
    pub fn reliable() -> Self {
        Self {
            reliable: true,
            ..Self::default()
        }
    }
}
