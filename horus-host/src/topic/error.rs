use thiserror::Error;

/// Why a topic could not be opened or used.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum TopicError {
    /// A name that no topic or domain can have.
    #[error("{name:?} cannot be the name of a {what}")]
    Name {
        /// `topic` or `domain`.
        what: &'static str,
        /// The name.
        name: String,
    },
    /// The topic exists with messages of another type or size.
    #[error("topic {topic} holds messages of another type or size than {wanted}")]
    Type {
        /// The topic.
        topic: String,
        /// The type asked for.
        wanted: &'static str,
    },
    /// The topic exists with options that are not these.
    #[error("topic {topic} was opened with other options: {reason}")]
    Options {
        /// The topic.
        topic: String,
        /// What iceoryx2 said.
        reason: String,
    },
    /// Shared memory could not be opened or created.
    #[error("cannot open topic {topic}: {reason}")]
    Open {
        /// The topic.
        topic: String,
        /// What iceoryx2 said.
        reason: String,
    },
    /// A message could not be made, sent or received.
    #[error("cannot {what} on topic {topic}: {reason}")]
    Use {
        /// What was attempted.
        what: &'static str,
        /// The topic.
        topic: String,
        /// What iceoryx2 said.
        reason: String,
    },
    /// A message has more elements than its type.
    #[error("{len} elements do not fit into a message of {capacity}")]
    TooLong {
        /// Elements given.
        len: usize,
        /// Elements of the type.
        capacity: usize,
    },
    /// Not as many subscribers came as were waited for.
    #[error("topic {topic} has {ready} of {wanted} subscribers")]
    NoSubscribers {
        /// The topic.
        topic: String,
        /// Subscribers that are connected.
        ready: usize,
        /// Subscribers waited for.
        wanted: usize,
    },
}
