//! FNV-1a, 32 bits: short, and the same everywhere.

/// A running hash.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hash(pub u32);

impl Default for Hash {
    fn default() -> Self {
        Self(0x811c_9dc5)
    }
}

impl Hash {
    /// Adds one byte.
    pub fn byte(&mut self, byte: u8) {
        self.0 = (self.0 ^ u32::from(byte)).wrapping_mul(0x0100_0193);
    }

    /// Adds four bytes, lowest first.
    pub fn word(&mut self, word: u32) {
        word.to_le_bytes().into_iter().for_each(|b| self.byte(b));
    }
}
