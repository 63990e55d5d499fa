//! Writing and reading the fields of a payload.

use crate::geometry::Pose2D;

/// Appends fields to a buffer. What does not fit is dropped: the buffer is as long as the longest
/// payload that is written at once.
#[derive(Debug)]
pub struct Put<'a> {
    buffer: &'a mut [u8],
    len: usize,
}

impl<'a> Put<'a> {
    /// Appends to `buffer`, whose first `len` bytes are taken.
    pub(super) fn new(buffer: &'a mut [u8], len: usize) -> Self {
        Self { buffer, len }
    }

    /// Bytes taken.
    pub(super) fn len(&self) -> usize {
        self.len
    }

    /// One byte.
    #[inline]
    pub fn u8(&mut self, value: u8) {
        if let Some(byte) = self.buffer.get_mut(self.len) {
            *byte = value;
            self.len += 1;
        }
    }

    /// Bytes as they are.
    pub fn bytes(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|byte| self.u8(*byte));
    }

    /// Two bytes.
    pub fn u16(&mut self, value: u16) {
        self.bytes(&value.to_le_bytes());
    }

    /// Four bytes.
    pub fn u32(&mut self, value: u32) {
        self.bytes(&value.to_le_bytes());
    }

    /// Eight bytes.
    pub fn u64(&mut self, value: u64) {
        self.bytes(&value.to_le_bytes());
    }

    /// Four bytes, the float's bits.
    pub fn f32(&mut self, value: f32) {
        self.u32(value.to_bits());
    }

    /// One to five bytes, LEB128.
    pub fn varint(&mut self, value: u32) {
        let mut rest = value;
        while rest > 0x7f {
            self.u8(rest as u8 | 0x80);
            rest >>= 7;
        }
        self.u8(rest as u8);
    }

    /// x, y, theta.
    pub fn pose(&mut self, pose: Pose2D) {
        [pose.x, pose.y, pose.theta]
            .into_iter()
            .for_each(|value| self.f32(value));
    }

    /// A length byte and as many whole characters of a text as 32 bytes hold.
    pub fn name(&mut self, name: &str) {
        let end = name.floor_char_boundary(Take::LONGEST_NAME);
        let bytes = name.as_bytes().get(..end).unwrap_or_default();
        self.u8(bytes.len() as u8);
        self.bytes(bytes);
    }
}

/// Reads fields off the front of a payload; `None` where it is too short or a value is impossible.
#[derive(Clone, Copy, Debug)]
pub struct Take<'a>(&'a [u8]);

impl<'a> Take<'a> {
    /// Longest name, bytes.
    const LONGEST_NAME: usize = 32;

    /// Reads from `bytes`.
    pub fn new(bytes: &'a [u8]) -> Self {
        Self(bytes)
    }

    /// True if nothing is left.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// All that is left.
    pub fn rest(&mut self) -> &'a [u8] {
        core::mem::take(&mut self.0)
    }

    /// The next `len` bytes.
    pub fn bytes(&mut self, len: usize) -> Option<&'a [u8]> {
        let (field, rest) = self.0.split_at_checked(len)?;
        self.0 = rest;
        Some(field)
    }

    fn array<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (field, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(*field)
    }

    /// One byte.
    pub fn u8(&mut self) -> Option<u8> {
        self.array::<1>().map(|[byte]| byte)
    }

    /// Two bytes.
    pub fn u16(&mut self) -> Option<u16> {
        self.array().map(u16::from_le_bytes)
    }

    /// Four bytes.
    pub fn u32(&mut self) -> Option<u32> {
        self.array().map(u32::from_le_bytes)
    }

    /// Eight bytes.
    pub fn u64(&mut self) -> Option<u64> {
        self.array().map(u64::from_le_bytes)
    }

    /// A float from its bits.
    pub fn f32(&mut self) -> Option<f32> {
        self.u32().map(f32::from_bits)
    }

    /// LEB128 of at most 32 bits.
    pub fn varint(&mut self) -> Option<u32> {
        let mut value = 0;
        for shift in (0..32).step_by(7) {
            let byte = self.u8()?;
            let bits = u32::from(byte & 0x7f);
            if shift == 28 && byte > 0x0f {
                return None;
            }
            value |= bits << shift;
            if byte < 0x80 {
                return Some(value);
            }
        }
        None
    }

    /// x, y, theta.
    pub fn pose(&mut self) -> Option<Pose2D> {
        Some(Pose2D::new(self.f32()?, self.f32()?, self.f32()?))
    }

    /// A text of at most 32 bytes.
    pub fn name(&mut self) -> Option<&'a str> {
        let len = usize::from(self.u8()?);
        if len > Self::LONGEST_NAME {
            return None;
        }
        core::str::from_utf8(self.bytes(len)?).ok()
    }

    /// False or true, as 0 or 1.
    pub fn flag(&mut self) -> Option<bool> {
        match self.u8()? {
            0 => Some(false),
            1 => Some(true),
            _ => None,
        }
    }
}
