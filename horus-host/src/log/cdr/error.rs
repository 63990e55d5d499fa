use thiserror::Error;

/// Why a payload could not be encoded or decoded. Byte positions count from the start of the
/// payload, its 4-byte header included.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum CdrError {
    /// Shorter than the encapsulation header.
    #[error("the payload has {len} bytes, fewer than the 4 of its encapsulation header")]
    NoHeader {
        /// Length of the payload.
        len: usize,
    },
    /// An XCDR2 encapsulation (ids 0x0006 to 0x000b).
    #[error("the payload is XCDR2 (encapsulation id {id:#06x}), and only XCDR1 is read")]
    Xcdr2 {
        /// The encapsulation id found.
        id: u16,
    },
    /// Neither plain XCDR1 nor XCDR2.
    #[error("the encapsulation id {id:#06x} is not plain XCDR1 (0x0000 or 0x0001)")]
    UnknownEncapsulation {
        /// The encapsulation id found.
        id: u16,
    },
    /// A field reaches past the end of the payload.
    #[error("the payload ends inside the {wanted}-byte field at byte {at}")]
    Truncated {
        /// Where the field (or the padding before it) starts.
        at: usize,
        /// Bytes the field takes.
        wanted: usize,
    },
    /// A sequence claims more elements than the rest of the payload can hold.
    #[error("the sequence at byte {at} claims {count} elements, but only {left} bytes follow")]
    SequenceTooLong {
        /// Where the first element would start.
        at: usize,
        /// Elements claimed.
        count: usize,
        /// Bytes left in the payload.
        left: usize,
    },
    /// A string without its terminating zero byte, or with one inside.
    #[error("the string at byte {at} is not terminated by its only zero byte")]
    StringTermination {
        /// Where the characters start.
        at: usize,
    },
    /// A string that is not UTF-8.
    #[error("the string at byte {at} is not valid UTF-8")]
    StringNotUtf8 {
        /// Where the characters start.
        at: usize,
    },
    /// More bytes than the type has, so the payload is of another type.
    #[error("{left} bytes follow the last field at byte {at}")]
    Trailing {
        /// Where the last field ends.
        at: usize,
        /// Bytes after it.
        left: usize,
    },
    /// A string or sequence to encode has more than `u32::MAX` elements.
    #[error("a sequence of {len} elements does not fit the 32-bit length field")]
    TooLong {
        /// Number of elements.
        len: usize,
    },
    /// A string to encode contains a zero byte, which is the terminator.
    #[error("the string {text:?} contains a zero byte")]
    NulInString {
        /// The string.
        text: String,
    },
}
