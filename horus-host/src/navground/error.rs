use thiserror::Error;

use crate::yaml::YamlError;

/// Why a configuration file cannot be used.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ConfigError {
    /// The text is larger than any configuration.
    #[error("{0} bytes are more than the {max} of a configuration", max = super::LocalMapFile::MOST_BYTES)]
    TooLarge(usize),
    /// The text is no YAML, or a key is given twice or has a value of the wrong type or out of range.
    #[error(transparent)]
    Yaml(#[from] YamlError),
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
}
