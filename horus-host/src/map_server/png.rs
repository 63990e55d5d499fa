//! PNG images, row by row where they are not interlaced.

use std::io::{BufRead, Seek, Write};

use ::png::{
    BitDepth, ColorType, Decoder, DecodingError, Encoder, EncodingError, Limits, Reader, Transformations,
};

use super::image::{ImageError, Pixel};

/// Most bytes that decoding may allocate: an interlaced image has to be held whole.
const DECODE_LIMIT: usize = 128 << 20;

/// An image whose header has been read.
pub(super) struct PngReader<R: BufRead + Seek> {
    reader: Reader<R>,
    channels: usize,
    /// The whole image, if it is interlaced, and how many rows of it were given out.
    interlaced: Option<(Vec<u8>, usize)>,
}

impl<R: BufRead + Seek> PngReader<R> {
    pub fn new(source: R) -> Result<Self, ImageError> {
        let mut decoder = Decoder::new_with_limits(source, Limits { bytes: DECODE_LIMIT });
        decoder.set_transformations(Transformations::EXPAND | Transformations::STRIP_16);
        let reader = decoder.read_info()?;
        let channels = reader.output_color_type().0.samples();
        Ok(Self {
            reader,
            channels,
            interlaced: None,
        })
    }

    pub fn size(&self) -> (u32, u32) {
        (self.reader.info().width, self.reader.info().height)
    }

    /// Reads the next row, from the top.
    pub fn next_row(&mut self, row: &mut [Pixel]) -> Result<(), ImageError> {
        if self.reader.info().interlaced && self.interlaced.is_none() {
            self.interlaced = Some((self.whole()?, 0));
        }
        let samples = match &mut self.interlaced {
            Some((image, rows)) => {
                let start = *rows * row.len() * self.channels;
                *rows += 1;
                image.get(start..).unwrap_or_default()
            }
            None => match self.reader.next_row()? {
                Some(row) => row.data(),
                None => &[],
            },
        };
        if samples.len() < row.len() * self.channels {
            return Err(ImageError::Malformed("the image ends too early"));
        }
        for (pixel, samples) in row.iter_mut().zip(samples.chunks_exact(self.channels)) {
            *pixel = match *samples {
                [shade] => opaque(shade),
                [shade, alpha] => Pixel {
                    shade,
                    is_opaque: alpha == u8::MAX,
                },
                [r, g, b] => opaque(luma(r, g, b)),
                [r, g, b, alpha] => Pixel {
                    shade: luma(r, g, b),
                    is_opaque: alpha == u8::MAX,
                },
                _ => {
                    return Err(ImageError::Malformed(
                        "the image has an unknown number of channels",
                    ));
                }
            };
        }
        Ok(())
    }

    fn whole(&mut self) -> Result<Vec<u8>, ImageError> {
        let too_large = ImageError::Malformed("the interlaced image is too large");
        let Some(bytes) = self.reader.output_buffer_size() else {
            return Err(too_large);
        };
        let mut image = Vec::new();
        if bytes > DECODE_LIMIT || image.try_reserve_exact(bytes).is_err() {
            return Err(too_large);
        }
        image.resize(bytes, 0);
        self.reader.next_frame(&mut image)?;
        Ok(image)
    }
}

fn opaque(shade: u8) -> Pixel {
    Pixel {
        shade,
        is_opaque: true,
    }
}

/// The shade of a colour: Rec. 709 luma, as ImageMagick turns colour into grey.
fn luma(r: u8, g: u8, b: u8) -> u8 {
    let sum = 212_656 * u32::from(r) + 715_158 * u32::from(g) + 72_186 * u32::from(b);
    ((sum + 500_000) / 1_000_000) as u8
}

/// Writes a grey PNG from rows of pixels, the top row first; with alpha if `with_alpha`.
pub(super) fn write(
    sink: impl Write,
    (width, height): (u32, u32),
    with_alpha: bool,
    mut row: impl FnMut(u32, &mut [Pixel]),
) -> Result<(), EncodingError> {
    let mut encoder = Encoder::new(sink, width, height);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_color(match with_alpha {
        true => ColorType::GrayscaleAlpha,
        false => ColorType::Grayscale,
    });
    let mut writer = encoder.write_header()?;
    let mut stream = writer.stream_writer()?;
    let mut pixels = vec![opaque(0); width as usize];
    let mut samples = Vec::with_capacity(2 * pixels.len());
    for gy in (0..height).rev() {
        row(gy, &mut pixels);
        samples.clear();
        for pixel in &pixels {
            samples.push(pixel.shade);
            if with_alpha {
                samples.push(if pixel.is_opaque { u8::MAX } else { 0 });
            }
        }
        stream.write_all(&samples)?;
    }
    stream.finish()?;
    writer.finish()
}

impl From<DecodingError> for ImageError {
    fn from(error: DecodingError) -> Self {
        Self::Png(error)
    }
}
