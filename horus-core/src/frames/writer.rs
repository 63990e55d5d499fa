use super::packer::Packer;
use super::row_coder::RowCoder;
use super::{MIN_BUFFER, MapLayer, Payload, ScanPart, Session, TickEnd, TickStart};
use crate::costmap::{CostMap, FieldCell};
use crate::error::{Buffer, Error, require};
use crate::geometry::CellRect;
use crate::grid::OccupancyGrid;

/// Writes single frames: what [`MapStream`](super::MapStream) is made of.
///
/// Frames are built in a caller-provided buffer and handed, whole, to `sink`, which may block or
/// may drop a frame: the listener then reports a gap and waits for the next key tick.
#[derive(Debug)]
pub struct FrameWriter<'b, S> {
    packer: Packer<'b>,
    sink: S,
}

impl<'b, S: FnMut(&[u8])> FrameWriter<'b, S> {
    /// A writer over a buffer of [`MIN_BUFFER`] bytes or more; beyond
    /// [`MAX_FRAME`](super::MAX_FRAME) it is not used.
    ///
    /// # Errors
    /// [`Error::BufferTooSmall`].
    pub fn new_in(buffer: &'b mut [u8], sink: S) -> Result<Self, Error> {
        require(Buffer::Frame, MIN_BUFFER, buffer.len())?;
        Ok(Self {
            packer: Packer::new(buffer),
            sink,
        })
    }

    /// Frames written so far, modulo 2^32.
    pub fn frames(&self) -> u32 {
        self.packer.sequence()
    }

    /// What the frames go to.
    pub fn sink_mut(&mut self) -> &mut S {
        &mut self.sink
    }

    /// Writes a session.
    pub fn session(&mut self, session: &Session<'_>) {
        self.payload(session);
    }

    /// Writes the start of a tick.
    pub fn tick_start(&mut self, start: &TickStart) {
        self.payload(start);
    }

    /// Writes the end of a tick.
    pub fn tick_end(&mut self, end: TickEnd) {
        self.payload(&end);
    }

    /// Writes the ranges of a tick's scan (metres), in as many frames as it takes.
    ///
    /// # Complexity
    /// Four bytes per beam.
    pub fn ranges(&mut self, ranges: &[f32]) {
        let mut rest = ranges;
        while !rest.is_empty() {
            self.packer.begin(ScanPart::KIND);
            let part = ScanPart::starting_at((ranges.len() - rest.len()) as u32);
            self.packer.put(|out| part.put(out));
            let n = rest.len().min(self.packer.room() / size_of::<f32>());
            let (now, later) = rest.split_at(n);
            self.packer
                .put(|out| now.iter().for_each(|range| out.f32(*range)));
            (self.sink)(self.packer.finish());
            rest = later;
        }
    }

    /// Writes the occupancy in a rectangle, cut to the grid, in as many frames as it takes.
    ///
    /// # Complexity
    /// Two reads per cell in the rectangle, at most one byte and 1/64 per cell.
    pub fn occupancy<C: AsRef<[i8]>>(&mut self, grid: &OccupancyGrid<C>, rect: CellRect) {
        let (size, data) = ((grid.width(), grid.height()), grid.data());
        let row = |gy| part(data, size.0, gy, rect).iter().map(|cell| *cell as u8);
        self.rows(MapLayer::Occupancy, size, rect, row);
    }

    /// Writes the costs in a rectangle, cut to the map, in as many frames as it takes: the kept
    /// bytes where there are any, as of the last update, else the present ones.
    ///
    /// # Complexity
    /// As [`occupancy`](Self::occupancy); without kept bytes each read is a table look-up.
    pub fn costs<F: FieldCell>(&mut self, map: &CostMap<'_, F>, rect: CellRect) {
        let size = (map.info().width(), map.info().height());
        match map.costs() {
            Some(kept) => {
                let row = |gy| part(kept, size.0, gy, rect).iter().copied();
                self.rows(MapLayer::Costs, size, rect, row);
            }
            None => {
                let row = |gy| map.row_part(gy, rect.x0, rect.x1);
                self.rows(MapLayer::Costs, size, rect, row);
            }
        }
    }

    fn rows<I: Iterator<Item = u8>>(
        &mut self,
        layer: MapLayer,
        (width, height): (u32, u32),
        rect: CellRect,
        row: impl Fn(u32) -> I,
    ) {
        let rect = CellRect {
            x1: rect.x1.min(width),
            y1: rect.y1.min(height),
            ..rect
        };
        if rect.width() == 0 || rect.height() == 0 {
            return;
        }
        let mut coder = RowCoder::new(&mut self.packer, &mut self.sink, layer, rect);
        for gy in rect.y0..rect.y1 {
            let below = (gy > rect.y0).then(|| row(gy - 1));
            coder.row(row(gy), below);
        }
        coder.finish();
    }

    fn payload<'p>(&mut self, payload: &impl Payload<'p>) {
        begin(&mut self.packer, payload);
        (self.sink)(self.packer.finish());
    }
}

fn begin<'p, P: Payload<'p>>(packer: &mut Packer<'_>, payload: &P) {
    packer.begin(P::KIND);
    packer.put(|out| payload.put(out));
}

/// The cells of a rectangle in row `gy`, which lies in the grid.
fn part<T>(cells: &[T], width: u32, gy: u32, rect: CellRect) -> &[T] {
    let start = gy as usize * width as usize;
    let columns = rect.x0 as usize..rect.x1.min(width) as usize;
    cells
        .get(start + columns.start..start + columns.end)
        .unwrap_or_default()
}
