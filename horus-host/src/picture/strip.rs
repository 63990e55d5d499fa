//! Pictures beside each other, and the bar that says how long a metre is.

use super::{Picture, PictureError, Pixels, Rgb};

/// Pixels between pictures, and around the bar.
const GAP: u32 = 8;
/// Height of the strip under a picture that the bar lies in.
const STRIP: u32 = 24;
const PAPER: Rgb = Rgb([255; 3]);
const INK: Rgb = Rgb([0; 3]);

/// Width and height of a glyph before it is enlarged.
const GLYPH: (u32, u32) = (3, 5);
/// Pixels per dot of a glyph.
const DOT: u32 = 2;

impl Picture {
    /// The pictures from left to right, aligned at the top, with some space between them.
    ///
    /// # Errors
    /// [`PictureError::BadScale`] if the result would exceed 2^28 pixels; [`PictureError::Empty`]
    /// without pictures.
    pub fn beside(pictures: &[Self]) -> Result<Self, PictureError> {
        let height = pictures.iter().map(|picture| picture.image().height()).max();
        let height = height.ok_or(PictureError::Empty { width: 0, height: 0 })?;
        let widths = pictures.iter().map(|picture| picture.image().width());
        let width = widths.fold(0, |sum: u32, width| sum.saturating_add(width + GAP)) - GAP;
        let mut whole = Self::blank(width, height, 1)?;
        whole.image_mut().iter_mut().for_each(|pixel| *pixel = PAPER);
        let mut x = 0;
        for picture in pictures {
            whole.image_mut().put(picture.image(), x, 0);
            x += picture.image().width() + GAP;
        }
        Ok(whole)
    }

    /// The picture over a strip with a bar of 1, 2 or 5 times a power of ten metres, the longest that
    /// takes at most a third of the width; without one where not even a millimetre fits.
    ///
    /// # Errors
    /// [`PictureError::BadScale`] if the result would exceed 2^28 pixels.
    pub fn with_scale_bar(self, metres_per_pixel: f64) -> Result<Self, PictureError> {
        let (width, height) = (self.image().width(), self.image().height());
        let mut whole = Self::blank(width, height.saturating_add(STRIP), 1)?;
        whole.image_mut().iter_mut().for_each(|pixel| *pixel = PAPER);
        whole.image_mut().put(self.image(), 0, 0);
        let longest = f64::from(width.saturating_sub(2 * GAP)) / 3.0 * metres_per_pixel;
        if let Some((metres, text)) = bar_length(longest) {
            let pixels = (metres / metres_per_pixel).round() as u32;
            let image = whole.image_mut();
            let middle = height + STRIP / 2;
            fill(image, GAP, middle - 1, pixels, 3, INK);
            for end in [GAP, GAP + pixels.saturating_sub(2)] {
                fill(image, end, middle - 5, 2, 11, INK);
            }
            write(image, GAP + pixels + GAP, middle - GLYPH.1 * DOT / 2, &text);
        }
        Ok(whole)
    }
}

/// The longest 1, 2 or 5 times a power of ten up to `longest` metres, from a millimetre to a
/// thousand kilometres, and its name.
fn bar_length(longest: f64) -> Option<(f64, String)> {
    let mut best = None;
    for power in -3..=6 {
        for digit in [1.0, 2.0, 5.0] {
            // Through text, so that 0.1 is 0.1.
            let metres: f64 = format!("{digit}e{power}").parse().ok()?;
            if metres <= longest {
                best = Some((metres, format!("{metres} m")));
            }
        }
    }
    best
}

fn fill(image: &mut Pixels, x: u32, y: u32, width: u32, height: u32, colour: Rgb) {
    for y in y..y.saturating_add(height).min(image.height()) {
        for x in x..x.saturating_add(width).min(image.width()) {
            image.set(x, y, colour);
        }
    }
}

/// Writes digits, points and `m`, as far as there is room.
fn write(image: &mut Pixels, mut x: u32, y: u32, text: &str) {
    for character in text.chars() {
        for (row, bits) in (0..).zip(glyph(character)) {
            for column in (0..GLYPH.0).filter(|column| bits >> (GLYPH.0 - 1 - column) & 1 == 1) {
                fill(image, x + column * DOT, y + row * DOT, DOT, DOT, INK);
            }
        }
        x += (GLYPH.0 + 1) * DOT;
    }
}

/// Rows of three dots each.
fn glyph(character: char) -> [u8; 5] {
    match character {
        '0' => [0b111, 0b101, 0b101, 0b101, 0b111],
        '1' => [0b010, 0b110, 0b010, 0b010, 0b111],
        '2' => [0b111, 0b001, 0b111, 0b100, 0b111],
        '5' => [0b111, 0b100, 0b111, 0b001, 0b111],
        '.' => [0, 0, 0, 0, 0b010],
        'm' => [0, 0, 0b111, 0b111, 0b101],
        _ => [0; 5],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::{Cells, palette};

    fn square(side: u32, scale: u32) -> Picture {
        let cells = vec![100i8; (side * side) as usize];
        Picture::paint(Cells::new(side, side, &cells).unwrap(), scale, palette::occupancy).unwrap()
    }

    #[test]
    fn bars_are_round_numbers() {
        let name = |longest| bar_length(longest).map(|(_, text)| text);
        assert_eq!(name(3.3).as_deref(), Some("2 m"));
        assert_eq!(name(0.99).as_deref(), Some("0.5 m"));
        assert_eq!(name(0.1).as_deref(), Some("0.1 m"));
        assert_eq!(name(60.0).as_deref(), Some("50 m"));
        assert_eq!(name(0.0001), None);
        assert_eq!(name(f64::NAN), None);
    }

    #[test]
    fn the_bar_is_as_long_as_it_says() {
        // 300 pixels of 0.02 m: at most 1.89 m, so 1 m, which is 50 pixels.
        let picture = square(100, 3).with_scale_bar(0.02).unwrap();
        let image = picture.image();
        assert_eq!((image.width(), image.height()), (300, 324));
        let row: Vec<u32> = (0..300).filter(|&x| image.get(x, 312) == Some(INK)).collect();
        assert_eq!(row[..50], (8..58).collect::<Vec<_>>()[..]);
        assert!(row[50..].iter().all(|&x| x >= 66), "then the text");
        assert!(square(1, 1).with_scale_bar(1e-9).is_ok());
    }

    #[test]
    fn pictures_stand_beside_each_other() {
        let whole = Picture::beside(&[square(2, 5), square(3, 5)]).unwrap();
        assert_eq!((whole.image().width(), whole.image().height()), (10 + 8 + 15, 15));
        assert_eq!(whole.image().get(9, 9), Some(INK));
        assert_eq!(whole.image().get(9, 10), Some(PAPER));
        assert_eq!(whole.image().get(12, 0), Some(PAPER));
        assert_eq!(whole.image().get(32, 14), Some(INK));
        assert!(Picture::beside(&[]).is_err());
    }
}
