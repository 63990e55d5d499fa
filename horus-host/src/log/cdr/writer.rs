use super::CdrError;

/// Little-endian XCDR1 encapsulation: id 0x0001, options 0.
const HEADER: [u8; 4] = [0, 1, 0, 0];

/// Writes one XCDR1 little-endian payload.
///
/// Writing itself cannot fail; what cannot be represented (a zero byte inside a string, a sequence
/// longer than `u32::MAX`) is remembered and reported by [`finish`](Self::finish).
#[derive(Debug, Clone)]
pub struct CdrWriter {
    bytes: Vec<u8>,
    error: Option<CdrError>,
}

impl Default for CdrWriter {
    fn default() -> Self {
        Self::new()
    }
}

impl CdrWriter {
    /// Starts a payload: the encapsulation header is already written.
    pub fn new() -> Self {
        Self {
            bytes: HEADER.to_vec(),
            error: None,
        }
    }

    /// Starts the next payload in the same buffer.
    pub fn restart(&mut self) {
        self.bytes.clear();
        self.bytes.extend_from_slice(&HEADER);
        self.error = None;
    }

    /// The whole payload, encapsulation header included.
    ///
    /// # Errors
    /// The first thing that could not be represented ([`CdrError::NulInString`],
    /// [`CdrError::TooLong`]).
    pub fn finish(&self) -> Result<&[u8], CdrError> {
        match &self.error {
            Some(error) => Err(error.clone()),
            None => Ok(&self.bytes),
        }
    }

    /// Appends a number's little-endian bytes, aligned to their count.
    pub(super) fn number<const N: usize>(&mut self, bytes: [u8; N]) {
        self.align(N);
        self.bytes.extend_from_slice(&bytes);
    }

    /// Appends the element count of a sequence.
    pub fn length(&mut self, len: usize) {
        let count = u32::try_from(len).unwrap_or_else(|_| {
            self.error.get_or_insert(CdrError::TooLong { len });
            0
        });
        self.number(count.to_le_bytes());
    }

    /// Appends a string: length with the terminator, characters, terminator.
    pub fn string(&mut self, text: &str) {
        if text.as_bytes().contains(&0) {
            self.error.get_or_insert_with(|| CdrError::NulInString {
                text: text.to_owned(),
            });
        }
        self.length(text.len() + 1);
        self.bytes.extend_from_slice(text.as_bytes());
        self.bytes.push(0);
    }

    /// Appends bytes as they are, after padding to `alignment`; nothing at all if there are none.
    pub(super) fn raw(&mut self, alignment: usize, bytes: impl ExactSizeIterator<Item = u8>) {
        if bytes.len() > 0 {
            self.align(alignment);
            self.bytes.extend(bytes);
        }
    }

    /// Appends `f32` elements (without a count), aligned once.
    pub(super) fn floats(&mut self, values: &[f32]) {
        if !values.is_empty() {
            self.align(4);
            self.bytes.reserve(4 * values.len());
            for value in values {
                self.bytes.extend_from_slice(&value.to_le_bytes());
            }
        }
    }

    fn align(&mut self, alignment: usize) {
        let body = self.bytes.len() - HEADER.len();
        self.bytes
            .resize(HEADER.len() + body.next_multiple_of(alignment), 0);
    }
}
