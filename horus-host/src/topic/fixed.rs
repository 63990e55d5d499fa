use std::fmt;
use std::marker::PhantomData;

use iceoryx2::prelude::ZeroCopySend;

use super::TopicError;
use super::kind::{Counted, Kind};

/// A message of a size that is fixed at compile time.
///
/// # Safety
/// All bits zero are a value, and nothing in it points anywhere.
pub unsafe trait Payload: ZeroCopySend + fmt::Debug + 'static {
    /// HORUS's name for a topic of such messages.
    const TOPIC: &'static str;
}

/// A message of a kind with room for `N` elements, of which the header says how many are used.
#[repr(C)]
pub struct Fixed<K: Kind, const N: usize> {
    /// Size and place, or the geometry of a scan.
    pub header: K::Header,
    elements: [K::Element; N],
    kind: PhantomData<K>,
}

impl<K: Kind, const N: usize> Fixed<K, N> {
    /// The elements in use.
    pub fn elements(&self) -> &[K::Element] {
        let count = self.header.count().min(N);
        self.elements.get(..count).unwrap_or_default()
    }

    /// All `N` elements: storage for a core grid.
    pub fn elements_mut(&mut self) -> &mut [K::Element] {
        &mut self.elements
    }

    /// Takes header and elements over.
    ///
    /// # Errors
    /// [`TopicError::TooLong`]; nothing changes then.
    pub fn fill(&mut self, header: K::Header, elements: &[K::Element]) -> Result<(), TopicError> {
        match self.elements.get_mut(..elements.len()) {
            Some(room) => room.copy_from_slice(elements),
            None => {
                return Err(TopicError::TooLong {
                    len: elements.len(),
                    capacity: N,
                });
            }
        }
        self.header = header;
        Ok(())
    }
}

impl<K: Kind, const N: usize> fmt::Debug for Fixed<K, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Fixed")
            .field("header", &self.header)
            .field("capacity", &N)
            .finish_non_exhaustive()
    }
}

// SAFETY: `repr(C)` of plain header and elements; the name, by default that of the Rust type, tells
// kind and capacity.
unsafe impl<K: Kind, const N: usize> ZeroCopySend for Fixed<K, N> {}

// SAFETY: plain header and elements.
unsafe impl<K: Kind, const N: usize> Payload for Fixed<K, N> {
    const TOPIC: &'static str = K::TOPIC;
}

/// A pose in the plane.
#[derive(Debug, Clone, Copy, Default, PartialEq, ZeroCopySend)]
#[repr(C)]
pub struct PoseMsg {
    /// Nanoseconds since the epoch of its sender.
    pub timestamp_ns: u64,
    /// Metres.
    pub x: f64,
    /// Metres.
    pub y: f64,
    /// Radians, counter-clockwise.
    pub theta: f64,
}

// SAFETY: four numbers.
unsafe impl Payload for PoseMsg {
    const TOPIC: &'static str = "pose2d";
}
