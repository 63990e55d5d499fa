//! Colours and pixels.

/// A colour: red, green, blue.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Rgb(pub [u8; 3]);

/// Pixels, the top row first.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pixels {
    width: u32,
    colours: Vec<Rgb>,
}

impl Pixels {
    /// All of one colour; the caller has checked that there are not too many.
    pub(super) fn new(width: u32, height: u32, colour: Rgb) -> Self {
        Self {
            width,
            colours: vec![colour; width as usize * height as usize],
        }
    }

    /// Columns.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> u32 {
        self.colours.len().checked_div(self.width as usize).unwrap_or(0) as u32
    }

    /// The colour of a pixel, row 0 at the top; `None` outside.
    pub fn get(&self, x: u32, y: u32) -> Option<Rgb> {
        self.colours.get(self.index(x, y)?).copied()
    }

    /// The rows from the top.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[Rgb]> {
        self.colours.chunks_exact(self.width.max(1) as usize)
    }

    /// Gives a pixel a colour; outside nothing happens.
    pub(super) fn set(&mut self, x: u32, y: u32, colour: Rgb) {
        if let Some(pixel) = self.index(x, y).and_then(|i| self.colours.get_mut(i)) {
            *pixel = colour;
        }
    }

    /// Copies `other` so that its upper left pixel lies at (x, y), as far as there is room.
    pub(super) fn put(&mut self, other: &Self, x: u32, y: u32) {
        for (dy, row) in (0..).zip(other.rows()) {
            for (dx, &colour) in (0..).zip(row) {
                self.set(x.saturating_add(dx), y.saturating_add(dy), colour);
            }
        }
    }

    /// All pixels, row by row.
    pub(super) fn iter_mut(&mut self) -> impl Iterator<Item = &mut Rgb> {
        self.colours.iter_mut()
    }

    /// Red, green and blue of all pixels.
    pub(super) fn to_bytes(&self) -> Vec<u8> {
        self.colours.iter().flat_map(|colour| colour.0).collect()
    }

    fn index(&self, x: u32, y: u32) -> Option<usize> {
        (x < self.width).then(|| y as usize * self.width as usize + x as usize)
    }
}
