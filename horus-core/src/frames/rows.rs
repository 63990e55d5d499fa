use super::{FrameKind, MapLayer, Payload, Put, Take};
use crate::geometry::CellRect;

/// Cells of a rectangle of a map, row by row from its lowest, as tokens.
///
/// A rectangle that does not fit one frame goes on in the next. The first byte of a token:
///
/// | byte | what follows | meaning |
/// |---|---|---|
/// | `0x00 + n - 1`, n = 1..=64 | n bytes | these cells |
/// | `0x40 + n - 2`, n = 2..=64 | one byte | n cells of this value |
/// | `0x7f` | varint m, one byte | 65 + m cells of this value |
/// | `0x80 + n - 1`, n = 1..=127 | | n cells, each as the one below it (gy - 1) |
/// | `0xff` | varint m | 128 + m cells, each as the one below it |
///
/// Tokens go over the ends of rows. Cells of the rectangle's lowest row have no cell below them.
/// At worst n cells take n + ceil(n / 64) bytes, and one byte more per frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowsPart<'a> {
    /// Which map.
    pub layer: MapLayer,
    /// The rectangle; not empty.
    pub rect: CellRect,
    /// Cells of the rectangle in the parts before this one.
    pub start: u32,
    /// The tokens.
    pub tokens: &'a [u8],
}

/// Cells that a token of each kind codes in one byte, at least and at most.
pub(super) mod token {
    pub const LITERAL: u8 = 0x00;
    pub const RUN: u8 = 0x40;
    pub const COPY: u8 = 0x80;
    pub const LONGEST_LITERAL: u8 = 64;
    pub const SHORTEST_RUN: u32 = 2;
    pub const LONG_RUN: u32 = 65;
    pub const SHORTEST_COPY: u32 = 1;
    pub const LONG_COPY: u32 = 128;
    /// Most bytes of a token, a literal's cells but for the first not counted.
    pub const LONGEST: usize = 7;
}

impl<'a> RowsPart<'a> {
    /// Decodes the tokens into a map of `width` x `height` cells, row-major. Returns how many
    /// cells of the rectangle are known then; all of them if that is the rectangle's size.
    ///
    /// `None` if the part does not belong to such a map or its tokens are damaged; some of its cells
    /// may have been written then.
    ///
    /// # Complexity
    /// One write per cell.
    pub fn decode_into(&self, cells: &mut [u8], width: u32, height: u32) -> Option<u32> {
        let rect = self.rect;
        let (columns, stride) = (rect.width() as usize, width as usize);
        let fits = rect.x1 <= width && rect.y1 <= height && columns > 0 && rect.height() > 0;
        if !fits || stride.checked_mul(height as usize) != Some(cells.len()) {
            return None;
        }
        let all = columns * rect.height() as usize;
        let first_row = columns;
        let mut at = self.start as usize;
        let index = |at: usize| (rect.y0 as usize + at / columns) * stride + rect.x0 as usize + at % columns;
        let mut from = Take::new(self.tokens);
        while !from.is_empty() {
            let byte = from.u8()?;
            if byte < token::RUN {
                for value in from.bytes(usize::from(byte) + 1)? {
                    if at >= all {
                        return None;
                    }
                    *cells.get_mut(index(at))? = *value;
                    at += 1;
                }
            } else if byte < token::COPY {
                let n = length(byte - token::RUN, token::SHORTEST_RUN, token::LONG_RUN, &mut from)?;
                let value = from.u8()?;
                let end = at.checked_add(n).filter(|end| *end <= all)?;
                for at in at..end {
                    *cells.get_mut(index(at))? = value;
                }
                at = end;
            } else {
                let n = length(
                    byte - token::COPY,
                    token::SHORTEST_COPY,
                    token::LONG_COPY,
                    &mut from,
                )?;
                let end = at.checked_add(n).filter(|end| *end <= all)?;
                if at < first_row {
                    return None;
                }
                for at in at..end {
                    let i = index(at);
                    let below = *cells.get(i.checked_sub(stride)?)?;
                    *cells.get_mut(i)? = below;
                }
                at = end;
            }
        }
        u32::try_from(at).ok()
    }
}

/// The length of a run or copy whose first byte says `code`.
fn length(code: u8, shortest: u32, long: u32, from: &mut Take<'_>) -> Option<usize> {
    let n = shortest + u32::from(code);
    let n = if n == long {
        long.checked_add(from.varint()?)?
    } else {
        n
    };
    Some(n as usize)
}

impl<'a> Payload<'a> for RowsPart<'a> {
    const KIND: FrameKind = FrameKind::Rows;

    fn put(&self, out: &mut Put<'_>) {
        out.u8(self.layer as u8);
        for value in [
            self.rect.x0,
            self.rect.y0,
            self.rect.width(),
            self.rect.height(),
            self.start,
        ] {
            out.varint(value);
        }
        out.bytes(self.tokens);
    }

    fn take(from: &mut Take<'a>) -> Option<Self> {
        let layer = MapLayer::from_number(from.u8()?)?;
        let (x0, y0) = (from.varint()?, from.varint()?);
        let (width, height) = (from.varint()?, from.varint()?);
        let rect = CellRect {
            x0,
            y0,
            x1: x0.checked_add(width)?,
            y1: y0.checked_add(height)?,
        };
        let cells = width.checked_mul(height)?;
        let start = from.varint()?;
        (start < cells).then(|| Self {
            layer,
            rect,
            start,
            tokens: from.rest(),
        })
    }
}
