/// The place of a frame in the sequence.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Order {
    /// The first frame of the stream.
    First,
    /// It follows the frame before it.
    Next,
    /// So many frames are missing before it.
    Gap(u32),
    /// It, or a frame with its number, was to come earlier.
    Late,
}

/// Sequence numbers of a stream, modulo 2^32.
#[derive(Debug, Default)]
pub(super) struct Sequence {
    expected: Option<u32>,
}

impl Sequence {
    /// Where a frame with this number belongs.
    pub fn order(&self, sequence: u32) -> Order {
        match self.expected.map(|expected| sequence.wrapping_sub(expected)) {
            None => Order::First,
            Some(0) => Order::Next,
            Some(ahead) if ahead < 1 << 31 => Order::Gap(ahead),
            Some(_) => Order::Late,
        }
    }

    /// Expects the frame after this one next.
    pub fn follow(&mut self, sequence: u32) {
        self.expected = Some(sequence.wrapping_add(1));
    }
}
