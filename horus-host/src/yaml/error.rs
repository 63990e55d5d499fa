use thiserror::Error;

/// Why a YAML text was refused. Lines count from 1.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum YamlError {
    /// The text is no YAML.
    #[error("line {line}: {reason}")]
    Syntax {
        /// Where the parser gave up.
        line: usize,
        /// The parser's words.
        reason: String,
    },
    /// The text is not one mapping of keys to values.
    #[error("line {0}: one mapping of keys to values is expected")]
    NoMapping(usize),
    /// A key is given a second time.
    #[error("line {line}: {key}: the key is given twice, first in line {first}")]
    Duplicate {
        /// Of the second one.
        line: usize,
        /// The key.
        key: String,
        /// Line of the first one.
        first: usize,
    },
    /// A key that must be there is not.
    #[error("{0}: the key is missing")]
    Missing(&'static str),
    /// A key's value is refused.
    #[error("line {line}: {key}: {reason}")]
    Value {
        /// The key's.
        line: usize,
        /// The key.
        key: String,
        /// Why.
        reason: String,
    },
}
