use thiserror::Error;

/// Why a configuration file cannot be used.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ConfigError {
    /// The text is no YAML.
    #[error("line {line}: {reason}")]
    Syntax {
        /// From 1.
        line: usize,
        /// The parser's words.
        reason: String,
    },
    /// The text is larger than any configuration.
    #[error("{0} bytes are more than the {max} of a configuration", max = super::LocalMapFile::MOST_BYTES)]
    TooLarge(usize),
    /// The text is not one mapping of keys to values.
    #[error("line {0}: a configuration is one mapping of keys to values")]
    NoMapping(usize),
    /// There is no `type`.
    #[error("type: the key is missing; a local map has the type LocalGridMap")]
    NoType,
    /// A key is none of the properties.
    #[error("line {line}: {key}: no property has this name; there are {known}")]
    UnknownKey {
        /// From 1.
        line: usize,
        /// The key.
        key: String,
        /// All properties.
        known: String,
    },
    /// A key's value has another type.
    #[error("line {line}: {key}: the value must be of type {expected}")]
    Type {
        /// From 1.
        line: usize,
        /// The key.
        key: String,
        /// The type in navground's words.
        expected: &'static str,
    },
    /// A key's value is refused.
    #[error("line {line}: {key}: {reason}")]
    Value {
        /// From 1.
        line: usize,
        /// The key.
        key: String,
        /// Why.
        reason: String,
    },
}
