//! PGM images, ASCII (P2) and binary (P5), row by row.

use std::io::{self, BufRead, Write};

use super::image::{ImageError, Pixel};

/// Longest number in an image.
const DIGITS: usize = 10;

/// An image whose header has been read.
pub(super) struct PgmReader<R> {
    source: R,
    is_ascii: bool,
    pub width: u32,
    pub height: u32,
    brightest: u32,
}

impl<R: BufRead> PgmReader<R> {
    /// Reads the header, from the magic number on.
    pub fn new(mut source: R) -> Result<Self, ImageError> {
        let mut magic = [0; 2];
        source.read_exact(&mut magic)?;
        let is_ascii = match &magic {
            b"P2" => true,
            b"P5" => false,
            _ => return Err(ImageError::Malformed("the image is no PGM")),
        };
        let mut reader = Self {
            source,
            is_ascii,
            width: 0,
            height: 0,
            brightest: 0,
        };
        // The number is followed by exactly one blank, which reading it takes away.
        reader.width = reader.number()?;
        reader.height = reader.number()?;
        reader.brightest = reader.number()?;
        match reader.brightest {
            1..=65_535 => Ok(reader),
            _ => Err(ImageError::Malformed("the brightest shade must be 1 to 65535")),
        }
    }

    /// Reads the next row, from the top.
    pub fn next_row(&mut self, row: &mut [Pixel]) -> Result<(), ImageError> {
        for pixel in row {
            let value = match (self.is_ascii, self.brightest) {
                (true, _) => self.number()?,
                (false, ..=255) => u32::from(self.bytes::<1>()?[0]),
                (false, _) => u32::from(u16::from_be_bytes(self.bytes()?)),
            };
            if value > self.brightest {
                return Err(ImageError::Malformed(
                    "a pixel is brighter than the brightest shade",
                ));
            }
            *pixel = Pixel {
                shade: ((value * 255 + self.brightest / 2) / self.brightest) as u8,
                is_opaque: true,
            };
        }
        Ok(())
    }

    fn bytes<const N: usize>(&mut self) -> Result<[u8; N], ImageError> {
        let mut bytes = [0; N];
        self.source.read_exact(&mut bytes)?;
        Ok(bytes)
    }

    /// The next byte; `None` at the end.
    fn byte(&mut self) -> Result<Option<u8>, ImageError> {
        let byte = self.source.fill_buf()?.first().copied();
        self.source.consume(usize::from(byte.is_some()));
        Ok(byte)
    }

    /// The next decimal number after blanks and comments, with the one byte behind it.
    fn number(&mut self) -> Result<u32, ImageError> {
        let mut digits = 0;
        let mut number: u64 = 0;
        loop {
            match self.byte()? {
                Some(digit @ b'0'..=b'9') if digits < DIGITS => {
                    number = number * 10 + u64::from(digit - b'0');
                    digits += 1;
                }
                Some(b'#') if digits == 0 => while !matches!(self.byte()?, None | Some(b'\n' | b'\r')) {},
                Some(b' ' | b'\t' | b'\r' | b'\n' | 0x0b | 0x0c) if digits == 0 => {}
                None if digits == 0 => return Err(ImageError::Malformed("the image ends too early")),
                None | Some(b' ' | b'\t' | b'\r' | b'\n' | 0x0b | 0x0c) => {
                    return u32::try_from(number).map_err(|_| ImageError::Malformed("a number is too large"));
                }
                Some(b'#') => {
                    return Err(ImageError::Malformed(
                        "a comment follows a number without a blank",
                    ));
                }
                Some(_) => return Err(ImageError::Malformed("a number is expected")),
            }
        }
    }
}

/// Writes a binary PGM from rows of shades, the top row first.
pub(super) fn write(
    mut sink: impl Write,
    (width, height): (u32, u32),
    mut row: impl FnMut(u32, &mut [u8]),
) -> io::Result<()> {
    write!(sink, "P5\n{width} {height}\n255\n")?;
    let mut shades = vec![0; width as usize];
    for gy in (0..height).rev() {
        row(gy, &mut shades);
        sink.write_all(&shades)?;
    }
    sink.flush()
}
