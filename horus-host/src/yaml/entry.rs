use std::fmt::Display;

use super::YamlError;
use super::scalar::Scalar;

/// A key with its value, which is read as what the caller needs.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry<'y> {
    pub(super) key: String,
    pub(super) line: usize,
    pub(super) value: Value<'y>,
}

/// What a key can have.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Value<'y> {
    Scalar(Scalar<'y>),
    List(Vec<Scalar<'y>>),
    /// A mapping, a list of other things than scalars, or an alias.
    Other,
}

impl Entry<'_> {
    /// The key.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// The key's line, from 1.
    pub fn line(&self) -> usize {
        self.line
    }

    /// Whether nothing is given: the value is empty, `~` or `null`.
    pub fn is_null(&self) -> bool {
        self.read(Scalar::is_null)
    }

    /// A text, quoted or not.
    ///
    /// # Errors
    /// [`YamlError::Value`] for everything else: what looks like a number or a truth value must be quoted.
    pub fn text(&self) -> Result<&str, YamlError> {
        self.read(Scalar::text).ok_or_else(|| self.expected("a text"))
    }

    /// `true` or `false`.
    ///
    /// # Errors
    /// [`YamlError::Value`] for everything else.
    pub fn boolean(&self) -> Result<bool, YamlError> {
        self.read(Scalar::boolean)
            .ok_or_else(|| self.expected("true or false"))
    }

    /// A whole number, also as `0x1f` or `0o17`.
    ///
    /// # Errors
    /// [`YamlError::Value`] for everything else, and outside the range of `i64`.
    pub fn integer(&self) -> Result<i64, YamlError> {
        self.read(Scalar::integer)
            .ok_or_else(|| self.expected("a whole number"))
    }

    /// A number, also `.inf` and `.nan`.
    ///
    /// # Errors
    /// [`YamlError::Value`] for everything else.
    pub fn number(&self) -> Result<f64, YamlError> {
        self.read(Scalar::number).ok_or_else(|| self.expected("a number"))
    }

    /// A list of numbers as of [`Entry::number`].
    ///
    /// # Errors
    /// [`YamlError::Value`] for everything else.
    pub fn numbers(&self) -> Result<Vec<f64>, YamlError> {
        self.list(Scalar::number, "a list of numbers")
    }

    /// A list of texts as of [`Entry::text`].
    ///
    /// # Errors
    /// [`YamlError::Value`] for everything else.
    pub fn texts(&self) -> Result<Vec<&str>, YamlError> {
        self.list(Scalar::text, "a list of texts")
    }

    /// The error that this value is refused for a reason that the caller knows.
    pub fn refused(&self, reason: impl Display) -> YamlError {
        YamlError::Value {
            line: self.line,
            key: self.key.clone(),
            reason: reason.to_string(),
        }
    }

    fn expected(&self, what: &str) -> YamlError {
        match &self.value {
            Value::Scalar(scalar) => {
                // A line of a document is as long as it likes.
                let given: String = scalar.as_written().chars().take(60).collect();
                self.refused(format!("{what} is expected, not {}", given.escape_debug()))
            }
            _ => self.refused(format!("{what} is expected")),
        }
    }

    fn read<'s, T: Default>(&'s self, read: impl Fn(&'s Scalar<'s>) -> T) -> T {
        match &self.value {
            Value::Scalar(scalar) => read(scalar),
            _ => T::default(),
        }
    }

    fn list<'s, T>(
        &'s self,
        read: impl Fn(&'s Scalar<'s>) -> Option<T>,
        what: &str,
    ) -> Result<Vec<T>, YamlError> {
        let list = match &self.value {
            Value::List(list) => list.iter().map(read).collect(),
            _ => None,
        };
        list.ok_or_else(|| self.expected(what))
    }
}
