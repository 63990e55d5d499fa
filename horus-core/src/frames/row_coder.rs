use super::packer::Packer;
use super::rows::token;
use super::segment::Segment;
use super::{MapLayer, Payload, RowsPart};
use crate::geometry::CellRect;

/// Codes the cells of a rectangle, one after the other, into as many frames as it takes.
///
/// Cells wait as a [`Segment`] until one comes that does not belong to it and starts the next. So each
/// cell is looked at once, and once more as the one below.
pub(super) struct RowCoder<'c, 'b> {
    packer: &'c mut Packer<'b>,
    sink: &'c mut dyn FnMut(&[u8]),
    layer: MapLayer,
    rect: CellRect,
    /// Cells in tokens.
    coded: u32,
    /// The open literal: where its first byte stands, and its cells; 0 cells: none is open.
    literal: (usize, u8),
    segment: Segment,
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
            segment: Segment::default(),
        };
        coder.begin_frame();
        coder
    }

    /// Adds a row: its cells and, but for the first row, those below them.
    pub fn row(&mut self, cells: impl Iterator<Item = u8>, below: Option<impl Iterator<Item = u8>>) {
        match below {
            None => self.cells(cells.map(|cell| (cell, false))),
            Some(below) => self.cells(cells.zip(below).map(|(cell, below)| (cell, cell == below))),
        }
    }

    /// Sends what is left.
    pub fn finish(mut self) {
        self.code(self.segment);
        (self.sink)(self.packer.finish());
    }

    /// Adds cells, each with whether it equals the one below it.
    #[inline]
    fn cells(&mut self, cells: impl Iterator<Item = (u8, bool)>) {
        let mut segment = self.segment; // in registers
        cells.for_each(|(cell, is_copy)| {
            if !segment.add(cell, is_copy) {
                self.code(segment);
                segment = Segment::starting_with(cell, is_copy);
            }
        });
        self.segment = segment;
    }

    /// Codes the cells of a segment.
    fn code(&mut self, segment: Segment) {
        // With a literal open, another cell of it takes one byte and a new literal after it none.
        let (n, is_open) = (segment.len, self.literal.1 > 0);
        if segment.is_copy() && (n >= 2 || (n == 1 && !is_open)) {
            self.copy_token(n);
        } else if n >= 3 || (n == 2 && !is_open) {
            self.run_token(n, segment.value);
        } else {
            (0..n).for_each(|_| self.literal_cell(segment.value));
        }
    }

    fn copy_token(&mut self, n: u32) {
        self.make_room();
        self.length_token(token::COPY, n, token::SHORTEST_COPY, token::LONG_COPY);
        self.close(n);
    }

    fn run_token(&mut self, n: u32, value: u8) {
        self.make_room();
        self.length_token(token::RUN, n, token::SHORTEST_RUN, token::LONG_RUN);
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
