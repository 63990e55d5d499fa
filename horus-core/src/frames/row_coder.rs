use super::packer::Packer;
use super::rows::token;
use super::{MapLayer, Payload, RowsPart};
use crate::geometry::CellRect;

/// Codes the cells of a rectangle, one after the other, into as many frames as it takes.
///
/// Cells wait as a *segment* as long as all of them are equal, or all equal the cell below them;
/// the cell that ends both starts the next one. So each cell is looked at once.
pub(super) struct RowCoder<'c, 'b> {
    packer: &'c mut Packer<'b>,
    sink: &'c mut dyn FnMut(&[u8]),
    layer: MapLayer,
    rect: CellRect,
    /// Cells in tokens.
    coded: u32,
    /// The open literal: where its first byte stands, and its cells; 0 cells: none is open.
    literal: (usize, u8),
    /// First cell of the segment.
    value: u8,
    /// Cells of the segment, and how many of them are equal, and equal to the cell below, up to
    /// the first that is not.
    len: u32,
    run: u32,
    copy: u32,
}

impl<'c, 'b> RowCoder<'c, 'b> {
    pub fn new(
        packer: &'c mut Packer<'b>,
        sink: &'c mut dyn FnMut(&[u8]),
        layer: MapLayer,
        rect: CellRect,
    ) -> Self {
        let mut coder = Self {
            packer,
            sink,
            layer,
            rect,
            coded: 0,
            literal: (0, 0),
            value: 0,
            len: 0,
            run: 0,
            copy: 0,
        };
        coder.begin_frame();
        coder
    }

    /// Adds a row: its cells and, but for the first row, those below them.
    pub fn row(&mut self, cells: impl Iterator<Item = u8>, below: Option<impl Iterator<Item = u8>>) {
        match below {
            None => cells.for_each(|cell| self.cell(cell, false)),
            Some(below) => cells
                .zip(below)
                .for_each(|(cell, below)| self.cell(cell, cell == below)),
        }
    }

    /// Sends what is left.
    pub fn finish(mut self) {
        self.end_segment();
        (self.sink)(self.packer.finish());
    }

    #[inline]
    fn cell(&mut self, cell: u8, is_copy: bool) {
        let copies = is_copy && self.copy == self.len;
        let runs = cell == self.value && self.run == self.len;
        if self.len > 0 && (copies || runs) {
            self.len += 1;
            self.copy += u32::from(copies);
            self.run += u32::from(runs);
            return;
        }
        self.end_segment();
        self.value = cell;
        self.len = 1;
        self.run = 1;
        self.copy = u32::from(is_copy);
    }

    /// Codes the segment, and starts an empty one.
    fn end_segment(&mut self) {
        let n = core::mem::take(&mut self.len);
        if n == 0 {
            return;
        }
        // With a literal open, another cell of it takes one byte and a new literal after it none.
        let is_open = self.literal.1 > 0;
        if self.copy == n && (n >= 2 || !is_open) {
            self.copy_token(n);
        } else if n >= 3 || (n == 2 && !is_open) {
            self.run_token(n);
        } else {
            (0..n).for_each(|_| self.literal_cell(self.value));
        }
    }

    fn copy_token(&mut self, n: u32) {
        self.make_room();
        self.length_token(token::COPY, n, token::SHORTEST_COPY, token::LONG_COPY);
        self.close(n);
    }

    fn run_token(&mut self, n: u32) {
        self.make_room();
        self.length_token(token::RUN, n, token::SHORTEST_RUN, token::LONG_RUN);
        let value = self.value;
        self.packer.put(|out| out.u8(value));
        self.close(n);
    }

    fn length_token(&mut self, kind: u8, n: u32, shortest: u32, long: u32) {
        self.packer.put(|out| {
            out.u8(kind + (n.min(long) - shortest) as u8);
            if n >= long {
                out.varint(n - long);
            }
        });
    }

    /// Notes that a token codes `n` cells and that no literal is open.
    fn close(&mut self, n: u32) {
        self.coded += n;
        self.literal.1 = 0;
    }

    fn literal_cell(&mut self, value: u8) {
        self.make_room();
        let (position, cells) = self.literal;
        if cells == 0 || cells == token::LONGEST_LITERAL {
            self.literal = (self.packer.position(), 1);
            self.packer.put(|out| {
                out.u8(token::LITERAL);
                out.u8(value);
            });
        } else {
            self.literal.1 = cells + 1;
            self.packer.set(position, token::LITERAL + cells);
            self.packer.put(|out| out.u8(value));
        }
        self.coded += 1;
    }

    /// Goes on in the next frame if the longest token may not fit this one.
    fn make_room(&mut self) {
        if self.packer.room() < token::LONGEST {
            (self.sink)(self.packer.finish());
            self.begin_frame();
        }
    }

    fn begin_frame(&mut self) {
        self.literal.1 = 0;
        let part = RowsPart {
            layer: self.layer,
            rect: self.rect,
            start: self.coded,
            tokens: &[],
        };
        self.packer.begin(RowsPart::KIND);
        self.packer.put(|out| part.put(out));
    }
}
