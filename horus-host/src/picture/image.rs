//! Painted grids.

use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

use super::{Cells, PictureError, Pixels, Rgb, palette};

/// The largest picture painted: 768 MiB of colour.
const MOST_PIXELS: u64 = 1 << 28;

/// A painted grid; row 0 of the grid is at the bottom.
#[derive(Debug, Clone)]
pub struct Picture {
    image: Pixels,
    scale: u32,
}

impl Picture {
    /// Paints every cell as a square of `scale` x `scale` pixels in the colour of its value.
    ///
    /// # Errors
    /// [`PictureError::BadScale`] if the scale is 0 or the picture would exceed 2^28 pixels.
    ///
    /// # Complexity
    /// One palette call per cell, one write per pixel.
    pub fn paint<T: Copy>(
        cells: Cells<'_, T>,
        scale: u32,
        palette: impl Fn(T) -> Rgb,
    ) -> Result<Self, PictureError> {
        let mut picture = Self::blank(cells.width(), cells.height(), scale)?;
        {
            let mut pixels = picture.image.iter_mut();
            for row in cells.rows().rev() {
                let colours: Vec<_> = row.iter().map(|&value| palette(value)).collect();
                for _ in 0..scale {
                    for &colour in &colours {
                        for pixel in pixels.by_ref().take(scale as usize) {
                            *pixel = colour;
                        }
                    }
                }
            }
        }
        Ok(picture)
    }

    /// Paints where two grids of the same shape differ ([`palette::difference`]).
    ///
    /// # Errors
    /// [`PictureError::ShapesDiffer`], or as [`Picture::paint`].
    pub fn paint_difference<T: Copy + Ord>(
        first: Cells<'_, T>,
        second: Cells<'_, T>,
        scale: u32,
    ) -> Result<Self, PictureError> {
        let shape = |cells: &Cells<'_, T>| (cells.width(), cells.height());
        if shape(&first) != shape(&second) {
            return Err(PictureError::ShapesDiffer {
                first: shape(&first),
                second: shape(&second),
            });
        }
        let pairs = first.rows().flatten().zip(second.rows().flatten());
        let orders: Vec<_> = pairs.map(|(a, b)| a.cmp(b)).collect();
        let orders = Cells::new(first.width(), first.height(), &orders)?;
        Self::paint(orders, scale, palette::difference)
    }

    /// Colours the pixels around a point as a square of `2 * radius + 1` pixels, such as the end
    /// of a beam. The point is in cells: (0.5, 0.5) is the centre of the lowest left cell.
    /// What lies outside the picture is left out; a point that is not finite draws nothing.
    pub fn mark_point(&mut self, gx: f64, gy: f64, radius: u32, colour: Rgb) {
        let radius = f64::from(radius);
        let Some((x, y)) = self.pixel(gx, gy) else {
            return;
        };
        self.fill(x - radius, y - radius, x + radius, y + radius, colour);
    }

    /// Draws a robot as a filled disc with a heading line of twice its radius. Position and radius
    /// are in cells, the yaw in radians, counter-clockwise from +x. Not finite: draws nothing.
    pub fn mark_robot(&mut self, gx: f64, gy: f64, yaw: f64, radius: f64, colour: Rgb) {
        let Some((x, y)) = self.pixel(gx, gy) else {
            return;
        };
        let reach = libm::rint(radius * f64::from(self.scale));
        if !(reach >= 0.0 && reach.is_finite() && yaw.is_finite()) {
            return;
        }
        let reach = reach.min(f64::from(self.image.width().max(self.image.height())));
        for row in -reach as i64..=reach as i64 {
            let row = row as f64;
            let half = libm::floor(libm::sqrt(reach * reach - row * row));
            self.fill(x - half, y + row, x + half, y + row, colour);
        }
        let (sin, cos) = libm::sincos(yaw);
        for step in 0..=(2.0 * reach) as u32 {
            let step = f64::from(step);
            let (x, y) = (libm::rint(x + cos * step), libm::rint(y - sin * step));
            self.fill(x, y, x, y, colour);
        }
    }

    /// The pixels, the top row first.
    pub fn image(&self) -> &Pixels {
        &self.image
    }

    /// Writes the picture as a PNG file, replacing one that exists.
    ///
    /// # Errors
    /// [`PictureError::Write`], which names the path.
    pub fn save(&self, path: &Path) -> Result<(), PictureError> {
        self.write(path, None)
    }

    /// Writes the picture as [`save`](Self::save) does, with one colour transparent.
    ///
    /// # Errors
    /// [`PictureError::Write`], which names the path.
    pub fn save_with_transparent(&self, path: &Path, colour: Rgb) -> Result<(), PictureError> {
        self.write(path, Some(colour))
    }

    fn write(&self, path: &Path, transparent: Option<Rgb>) -> Result<(), PictureError> {
        let write = || -> Result<(), png::EncodingError> {
            let file = BufWriter::new(File::create(path)?);
            let mut encoder = png::Encoder::new(file, self.image.width(), self.image.height());
            encoder.set_color(png::ColorType::Rgb);
            if let Some(colour) = transparent {
                encoder.set_trns(colour.0.map(|channel| [0, channel]).concat());
            }
            let mut writer = encoder.write_header()?;
            writer.write_image_data(&self.image.to_bytes())?;
            writer.finish()
        };
        write().map_err(|source| PictureError::Write {
            path: path.to_path_buf(),
            source,
        })
    }

    pub(super) fn image_mut(&mut self) -> &mut Pixels {
        &mut self.image
    }

    pub(super) fn blank(width: u32, height: u32, scale: u32) -> Result<Self, PictureError> {
        let scaled = |cells: u32| cells.checked_mul(scale).filter(|&pixels| pixels > 0);
        scaled(width)
            .zip(scaled(height))
            .filter(|&(x, y)| u64::from(x) * u64::from(y) <= MOST_PIXELS)
            .map(|(x, y)| Self {
                image: Pixels::new(x, y, Rgb::default()),
                scale,
            })
            .ok_or(PictureError::BadScale {
                width,
                height,
                scale,
                most_pixels: MOST_PIXELS,
            })
    }

    /// The pixel (whole numbers, y down) that holds a point given in cells; it may lie outside.
    fn pixel(&self, gx: f64, gy: f64) -> Option<(f64, f64)> {
        let scale = f64::from(self.scale);
        let x = libm::floor(gx * scale);
        let y = f64::from(self.image.height()) - 1.0 - libm::floor(gy * scale);
        (x.is_finite() && y.is_finite()).then_some((x, y))
    }

    /// Colours the pixels of a closed rectangle that lie in the picture.
    fn fill(&mut self, left: f64, top: f64, right: f64, bottom: f64, colour: Rgb) {
        // Float to integer conversion saturates, so what lies left of or above 0 starts at 0, and
        // ends before it where the end is negative too.
        let end = |last: f64, size: u32| (last + 1.0).min(f64::from(size)) as u32;
        for y in top as u32..end(bottom, self.image.height()) {
            for x in left as u32..end(right, self.image.width()) {
                self.image.set(x, y, colour);
            }
        }
    }
}
