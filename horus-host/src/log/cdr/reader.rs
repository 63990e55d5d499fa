use super::CdrError;

/// Bytes of the encapsulation header; alignment is counted after them.
const HEADER_LEN: usize = 4;

/// Most padding a writer may leave after the last field (payloads are padded to 4 bytes).
const MAX_TRAILING: usize = 3;

/// Reads one XCDR1 payload of either byte order, checking every access.
///
/// A length field is believed only as far as the payload can hold it, so nothing is ever allocated
/// for bytes that are not there.
#[derive(Debug, Clone)]
pub struct CdrReader<'a> {
    payload: &'a [u8],
    at: usize,
    big_endian: bool,
}

impl<'a> CdrReader<'a> {
    /// Opens a payload that starts with its encapsulation header.
    ///
    /// # Errors
    /// [`CdrError::NoHeader`], [`CdrError::Xcdr2`] or [`CdrError::UnknownEncapsulation`].
    pub fn new(payload: &'a [u8]) -> Result<Self, CdrError> {
        let Some(&[high, low, _, _]) = payload.first_chunk::<HEADER_LEN>() else {
            return Err(CdrError::NoHeader { len: payload.len() });
        };
        let big_endian = match u16::from_be_bytes([high, low]) {
            0 => true,
            1 => false,
            id @ 0x0006..=0x000b => return Err(CdrError::Xcdr2 { id }),
            id => return Err(CdrError::UnknownEncapsulation { id }),
        };
        Ok(Self {
            payload,
            at: HEADER_LEN,
            big_endian,
        })
    }

    /// Checks that the payload ends here, but for the at most 3 bytes of padding writers add.
    ///
    /// # Errors
    /// [`CdrError::Trailing`].
    pub fn finish(&self) -> Result<(), CdrError> {
        match self.left() {
            0..=MAX_TRAILING => Ok(()),
            left => Err(CdrError::Trailing { at: self.at, left }),
        }
    }

    /// Reads a number's bytes, aligned to their count, in little-endian order.
    ///
    /// # Errors
    /// [`CdrError::Truncated`].
    pub(super) fn number<const N: usize>(&mut self) -> Result<[u8; N], CdrError> {
        let mut bytes = [0; N];
        bytes.copy_from_slice(self.raw(N, N)?);
        if self.big_endian {
            bytes.reverse();
        }
        Ok(bytes)
    }

    /// Reads the element count of a sequence whose elements take at least `min_len` bytes each.
    ///
    /// # Errors
    /// [`CdrError::Truncated`]; [`CdrError::SequenceTooLong`] if the rest of the payload cannot
    /// hold that many elements.
    pub fn length(&mut self, min_len: usize) -> Result<usize, CdrError> {
        let count = u32::from_le_bytes(self.number()?) as usize;
        let left = self.left();
        if count > left / min_len.max(1) {
            return Err(CdrError::SequenceTooLong {
                at: self.at,
                count,
                left,
            });
        }
        Ok(count)
    }

    /// Reads a string. A length of 0, which some writers emit for the empty string, is accepted.
    ///
    /// # Errors
    /// [`CdrError::Truncated`], [`CdrError::SequenceTooLong`], [`CdrError::StringTermination`],
    /// [`CdrError::StringNotUtf8`].
    pub fn string(&mut self) -> Result<String, CdrError> {
        let len = self.length(1)?;
        let at = self.at;
        let text = match self.raw(1, len)? {
            [] => &[],
            [text @ .., 0] if !text.contains(&0) => text,
            _ => return Err(CdrError::StringTermination { at }),
        };
        match str::from_utf8(text) {
            Ok(text) => Ok(text.to_owned()),
            Err(_) => Err(CdrError::StringNotUtf8 { at }),
        }
    }

    /// Reads `len` bytes as they are, after skipping the padding to `alignment`.
    ///
    /// # Errors
    /// [`CdrError::Truncated`].
    pub(super) fn raw(&mut self, alignment: usize, len: usize) -> Result<&'a [u8], CdrError> {
        let start = HEADER_LEN + (self.at - HEADER_LEN).next_multiple_of(alignment);
        let field = start
            .checked_add(len)
            .and_then(|end| self.payload.get(start..end));
        let Some(field) = field else {
            return Err(CdrError::Truncated {
                at: self.at,
                wanted: len,
            });
        };
        self.at = start + len;
        Ok(field)
    }

    /// Reads `count` `f32` elements.
    ///
    /// # Errors
    /// [`CdrError::Truncated`].
    pub(super) fn floats(&mut self, count: usize) -> Result<Vec<f32>, CdrError> {
        if count == 0 {
            return Ok(Vec::new());
        }
        let from_bytes = if self.big_endian {
            f32::from_be_bytes
        } else {
            f32::from_le_bytes
        };
        let (words, _) = self.raw(4, count.saturating_mul(4))?.as_chunks::<4>();
        Ok(words.iter().map(|word| from_bytes(*word)).collect())
    }

    fn left(&self) -> usize {
        self.payload.len() - self.at
    }
}
