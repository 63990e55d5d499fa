//! CRC-32 as in IEEE 802.3, zip and PNG.

/// Remainders of the 16 nibbles: 64 bytes of flash; two look-ups, about 10 instructions, per byte.
const TABLE: [u32; 16] = {
    let mut table = [0; 16];
    let mut nibble = 0;
    while nibble < 16 {
        let mut remainder = nibble as u32;
        let mut bit = 0;
        while bit < 4 {
            let carry = remainder & 1;
            remainder = (remainder >> 1) ^ (carry * 0xedb8_8320);
            bit += 1;
        }
        table[nibble] = remainder;
        nibble += 1;
    }
    table
};

/// A running checksum.
#[derive(Clone, Copy)]
pub(super) struct Crc32(u32);

impl Crc32 {
    pub const fn new() -> Self {
        Self(u32::MAX)
    }

    #[inline]
    pub fn byte(&mut self, byte: u8) {
        let step = |crc: u32| (crc >> 4) ^ TABLE[(crc & 15) as usize];
        self.0 = step(step(self.0 ^ u32::from(byte)));
    }

    pub const fn finish(self) -> u32 {
        !self.0
    }

    pub fn of(bytes: impl IntoIterator<Item = u8>) -> u32 {
        let mut crc = Self::new();
        bytes.into_iter().for_each(|byte| crc.byte(byte));
        crc.finish()
    }
}
