use std::collections::HashMap;

use saphyr_parser::{Event, Parser, StrInput};

use super::entry::Value;
use super::scalar::Scalar;
use super::{Entry, YamlError};

/// A text that is one mapping of keys to values, each key once.
#[derive(Debug, Clone, PartialEq)]
pub struct Document<'y> {
    entries: Vec<Entry<'y>>,
    /// Where in `entries` each key is.
    places: HashMap<String, usize>,
}

impl<'y> Document<'y> {
    /// Reads a text.
    ///
    /// Values are scalars and lists of scalars. What is nested deeper, and what aliases stand for, is not
    /// kept: such a key is there, but its value can only be ignored.
    ///
    /// # Errors
    /// [`YamlError::Syntax`] for what is no YAML and for keys that are no scalars; [`YamlError::NoMapping`] for
    /// anything but one document with a mapping; [`YamlError::Duplicate`].
    ///
    /// # Complexity
    /// Proportional to the text, in time and in memory, whatever is in it.
    pub fn parse(text: &'y str) -> Result<Self, YamlError> {
        // The parser takes the mark that some editors put first for a part of the first key.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut events = Events(Parser::new_from_str(text));
        events.start()?;
        let mut document = Self {
            entries: Vec::new(),
            places: HashMap::new(),
        };
        while let Some((key, line)) = events.key()? {
            let value = events.value()?;
            document.add(Entry { key, line, value })?;
        }
        events.end()?;
        Ok(document)
    }

    fn add(&mut self, entry: Entry<'y>) -> Result<(), YamlError> {
        if let Some(first) = self.get(&entry.key) {
            return Err(YamlError::Duplicate {
                line: entry.line,
                first: first.line,
                key: entry.key,
            });
        }
        self.places.insert(entry.key.clone(), self.entries.len());
        self.entries.push(entry);
        Ok(())
    }

    /// All keys, in their order.
    pub fn entries(&self) -> &[Entry<'y>] {
        &self.entries
    }

    /// A key, if it is given.
    pub fn get(&self, key: &str) -> Option<&Entry<'y>> {
        self.entries.get(*self.places.get(key)?)
    }

    /// A key that must be given.
    ///
    /// # Errors
    /// [`YamlError::Missing`].
    pub fn required(&self, key: &'static str) -> Result<&Entry<'y>, YamlError> {
        self.get(key).ok_or(YamlError::Missing(key))
    }
}

/// The parser's events, taken one by one: no recursion, so that no depth is too much.
struct Events<'y>(Parser<'y, StrInput<'y>>);

impl<'y> Events<'y> {
    /// An event and its line.
    fn next(&mut self) -> Result<(Event<'y>, usize), YamlError> {
        match self.0.next_event() {
            Some(Ok((event, span))) => Ok((event, span.start.line())),
            Some(Err(error)) => Err(YamlError::Syntax {
                line: error.marker().line(),
                reason: error.info().to_owned(),
            }),
            // The parser reports a missing end itself.
            None => Err(YamlError::Syntax {
                line: 1,
                reason: "the text ends too early".to_owned(),
            }),
        }
    }

    /// Up to the first key.
    fn start(&mut self) -> Result<(), YamlError> {
        loop {
            match self.next()? {
                (Event::StreamStart | Event::DocumentStart(_), _) => {}
                (Event::MappingStart(..), _) => return Ok(()),
                (_, line) => return Err(YamlError::NoMapping(line)),
            }
        }
    }

    /// The next key and its line; `None` behind the last.
    fn key(&mut self) -> Result<Option<(String, usize)>, YamlError> {
        match self.next()? {
            (Event::Scalar(key, ..), line) => Ok(Some((key.into_owned(), line))),
            (Event::MappingEnd, _) => Ok(None),
            (_, line) => Err(YamlError::Syntax {
                line,
                reason: "a key must be a text".to_owned(),
            }),
        }
    }

    fn value(&mut self) -> Result<Value<'y>, YamlError> {
        match self.next()?.0 {
            Event::Scalar(text, style, _, tag) => Ok(Value::Scalar(Scalar::new(text, style, tag.as_deref()))),
            Event::SequenceStart(..) => self.list(),
            Event::MappingStart(..) => self.skip(),
            _ => Ok(Value::Other),
        }
    }

    /// Behind the start of a list.
    fn list(&mut self) -> Result<Value<'y>, YamlError> {
        let (mut list, mut is_flat) = (Vec::new(), true);
        loop {
            match self.next()?.0 {
                Event::Scalar(text, style, _, tag) => list.push(Scalar::new(text, style, tag.as_deref())),
                Event::SequenceEnd if is_flat => return Ok(Value::List(list)),
                Event::SequenceEnd => return Ok(Value::Other),
                Event::SequenceStart(..) | Event::MappingStart(..) => {
                    self.skip()?;
                    is_flat = false;
                }
                _ => is_flat = false,
            }
        }
    }

    /// Behind the start of a list or mapping: passes its end.
    fn skip(&mut self) -> Result<Value<'y>, YamlError> {
        let mut depth = 1_usize;
        while depth > 0 {
            match self.next()?.0 {
                Event::SequenceStart(..) | Event::MappingStart(..) => depth += 1,
                Event::SequenceEnd | Event::MappingEnd => depth -= 1,
                _ => {}
            }
        }
        Ok(Value::Other)
    }

    /// Behind the mapping, there is nothing more.
    fn end(&mut self) -> Result<(), YamlError> {
        loop {
            match self.next()? {
                (Event::DocumentEnd, _) => {}
                (Event::StreamEnd, _) => return Ok(()),
                (_, line) => return Err(YamlError::NoMapping(line)),
            }
        }
    }
}
