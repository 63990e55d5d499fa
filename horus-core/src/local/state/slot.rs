use core::ops::Range;

use super::{ElementKind, Shape};
use crate::error::MAX_NAME;

/// Bytes of the longest field name with the `/` before it.
const MAX_FIELD: usize = 16;
/// Bytes of a buffer's name.
pub(super) const MAX_KEY: usize = MAX_NAME + MAX_FIELD;

/// Where a [`SensingState`](super::SensingState) keeps one named buffer. 76 bytes on a 32-bit target.
#[derive(Clone, Copy, Debug)]
pub struct BufferSlot {
    key: [u8; MAX_KEY],
    key_length: u8,
    pub(super) kind: ElementKind,
    pub(super) shape: Shape,
    start: usize,
    capacity: usize,
}

impl BufferSlot {
    /// All bits zero; the contents do not matter.
    pub const EMPTY: Self = Self {
        key: [0; MAX_KEY],
        key_length: 0,
        kind: ElementKind::F32,
        shape: Shape::EMPTY,
        start: 0,
        capacity: 0,
    };

    /// A buffer without contents over the elements `start..start + capacity`. The name and the field
    /// fit.
    pub(super) fn new(
        (name, field): (&str, &str),
        kind: ElementKind,
        (start, capacity): (usize, usize),
    ) -> Self {
        let mut slot = Self {
            kind,
            start,
            capacity,
            ..Self::EMPTY
        };
        let key = key(name, field);
        for (to, from) in slot.key.iter_mut().zip(key) {
            *to = from;
            slot.key_length += 1;
        }
        slot
    }

    /// `name/field`, or the field alone if there is no name.
    pub(super) fn key_str(&self) -> &str {
        let key = self.key.get(..usize::from(self.key_length)).unwrap_or_default();
        core::str::from_utf8(key).unwrap_or_default()
    }

    pub(super) fn is(&self, name: &str, field: &str) -> bool {
        self.key_str().bytes().eq(key(name, field))
    }

    pub(super) const fn capacity(&self) -> usize {
        self.capacity
    }

    /// The elements that are in use.
    pub(super) fn range(&self) -> Range<usize> {
        self.start..self.start + self.shape.elements().unwrap_or(0).min(self.capacity)
    }
}

fn key<'n>(name: &'n str, field: &'n str) -> impl Iterator<Item = u8> + 'n {
    let slash = if name.is_empty() { "" } else { "/" };
    name.bytes().chain(slash.bytes()).chain(field.bytes())
}
