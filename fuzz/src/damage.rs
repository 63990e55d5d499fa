//! What happens to stored and sent bytes.

use arbitrary::Arbitrary;

/// Something that happens to stored bytes.
#[derive(Clone, Debug, Arbitrary)]
pub enum Damage {
    /// A bit flips.
    Flip {
        /// Where, modulo the length.
        at: u16,
        /// Which bit.
        bit: u8,
    },
    /// Everything from here on is lost.
    Cut(u16),
    /// Bytes come in between.
    Insert(u16, Vec<u8>),
    /// Bytes go.
    Remove(u16, u8),
    /// Bytes become others.
    Overwrite(u16, Vec<u8>),
    /// A length becomes another, in eight bytes.
    Length(u16, u64),
    /// A length becomes another, in four bytes.
    Short(u16, u32),
    /// A part comes twice.
    Repeat(u16, u16),
}

impl Damage {
    /// Damages the bytes.
    pub fn apply(&self, bytes: &mut Vec<u8>) {
        let len = bytes.len();
        let place = |at: u16| usize::from(at) % len.max(1);
        match self {
            Self::Flip { at, bit } => {
                if let Some(byte) = bytes.get_mut(place(*at)) {
                    *byte ^= 1 << (bit % 8);
                }
            }
            Self::Cut(at) => bytes.truncate(place(*at)),
            Self::Insert(at, extra) => {
                let at = place(*at);
                bytes.splice(at..at, extra.iter().copied());
            }
            Self::Remove(at, count) => {
                let at = place(*at);
                bytes.drain(at..(at + usize::from(*count)).min(len));
            }
            Self::Overwrite(at, with) => overwrite(bytes, place(*at), with),
            Self::Length(at, length) => overwrite(bytes, place(*at), &length.to_le_bytes()),
            Self::Short(at, length) => overwrite(bytes, place(*at), &length.to_le_bytes()),
            Self::Repeat(at, count) => {
                let at = place(*at);
                let part = bytes[at..(at + usize::from(*count)).min(len)].to_vec();
                bytes.splice(at..at, part);
            }
        }
    }
}

fn overwrite(bytes: &mut [u8], at: usize, with: &[u8]) {
    for (to, from) in bytes.iter_mut().skip(at).zip(with) {
        *to = *from;
    }
}
