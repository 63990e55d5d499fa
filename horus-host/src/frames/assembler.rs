use std::sync::Arc;

use horus_core::frames::{Frame, MapChecksum, MapLayer, RowsPart, ScanPart, Session, TickEnd, TickStart};
use horus_core::geometry::CELL_LIMIT;
use horus_core::prelude::CellRect;

use super::problem::{ProblemKind, Problems};
use super::{StreamSession, StreamedTick, window};
use crate::lockstep::Layers;

/// Most beams of a scan.
const MOST_BEAMS: u32 = 1 << 20;

/// Puts frames that arrive in order together to ticks, and keeps the listener's copy of the map.
#[derive(Debug)]
pub(super) struct Assembler {
    most_cells: usize,
    session: Option<Arc<StreamSession>>,
    /// The frame before was a session: a key tick may follow.
    is_session_fresh: bool,
    /// The copy equals the sender's map as of the last tick that carried it.
    is_synced: bool,
    /// Whole cells the copy's window has moved.
    offset: [i32; 2],
    /// The copies, by [`MapLayer`].
    layers: [Vec<u8>; MapLayer::ALL.len()],
    open: Option<OpenTick>,
    skipped_ticks: u64,
}

/// A tick whose end has not come.
#[derive(Debug)]
struct OpenTick {
    start: TickStart,
    ranges: Vec<f32>,
    /// A rectangle whose cells are not all known yet, and how many are.
    rows: Option<(MapLayer, CellRect, u32)>,
    /// Layers that came as a whole.
    whole: [bool; MapLayer::ALL.len()],
}

/// The frame cannot be, or not here.
struct Refused(ProblemKind);

const INCONSISTENT: Refused = Refused(ProblemKind::Inconsistent);

impl Assembler {
    pub fn new(most_cells: usize) -> Self {
        Self {
            most_cells,
            session: None,
            is_session_fresh: false,
            is_synced: false,
            offset: [0; 2],
            layers: Default::default(),
            open: None,
            skipped_ticks: 0,
        }
    }

    /// Ticks that began and were not yielded.
    pub fn skipped_ticks(&self) -> u64 {
        self.skipped_ticks
    }

    /// A tick has begun and not ended.
    pub fn is_in_tick(&self) -> bool {
        self.open.is_some()
    }

    /// Frames were lost: nothing is known of the map until the next key tick.
    pub fn lose(&mut self) {
        self.is_synced = false;
        self.is_session_fresh = false;
        self.skipped_ticks += u64::from(self.open.take().is_some());
    }

    /// Takes the next frame; a tick if that one ends it.
    pub fn apply(&mut self, frame: &Frame<'_>, at: u64, problems: &mut Problems) -> Option<StreamedTick> {
        let result = match frame {
            Frame::Session(session) => self.session(session),
            Frame::TickStart(start) => self.start(start, at, problems),
            Frame::Scan(part) => self.scan(part),
            Frame::Rows(part) => self.rows(part),
            Frame::TickEnd(end) => return self.end(end, at, problems),
        };
        self.is_session_fresh = result.is_ok() && matches!(frame, Frame::Session(_));
        if let Err(Refused(kind)) = result {
            problems.add(kind, 1, at);
            self.lose();
        }
        None
    }

    fn session(&mut self, session: &Session<'_>) -> Result<(), Refused> {
        if self.open.is_some() {
            return Err(INCONSISTENT);
        }
        let session = StreamSession::new(session, self.most_cells).ok_or(Refused(ProblemKind::Malformed))?;
        if self.session.as_deref() != Some(&session) {
            self.session = Some(Arc::new(session));
            self.is_synced = false;
        }
        Ok(())
    }

    fn start(&mut self, start: &TickStart, at: u64, problems: &mut Problems) -> Result<(), Refused> {
        if self.open.is_some() {
            // The frame is as good as any, but the tick before it has no end.
            problems.add(ProblemKind::Inconsistent, 1, at);
            self.lose();
        }
        let is_possible = start
            .offset
            .into_iter()
            .all(|cells| (-CELL_LIMIT..=CELL_LIMIT).contains(&cells))
            && start.beams <= MOST_BEAMS
            && (start.has_maps || !start.is_key);
        let Some(session) = self.session.clone().filter(|_| is_possible) else {
            self.skipped_ticks += 1;
            return if is_possible {
                Ok(()) // joined late
            } else {
                Err(Refused(ProblemKind::Malformed))
            };
        };
        if start.is_key && self.is_session_fresh {
            for (layer, cells) in MapLayer::ALL.into_iter().zip(&mut self.layers) {
                cells.clear();
                cells.resize(session.config.cells(), layer.unseen());
            }
            self.offset = start.offset;
            self.is_synced = true;
        }
        if !self.is_synced {
            self.skipped_ticks += 1;
            return Ok(());
        }
        let moved = |axis: usize| i64::from(start.offset[axis]) - i64::from(self.offset[axis]);
        let by = [moved(0), moved(1)];
        for (layer, cells) in MapLayer::ALL.into_iter().zip(&mut self.layers) {
            window::shift(cells, session.config.width, by, layer.unseen());
        }
        self.offset = start.offset;
        self.open = Some(OpenTick {
            start: *start,
            ranges: Vec::new(),
            rows: None,
            whole: [false; MapLayer::ALL.len()],
        });
        Ok(())
    }

    fn scan(&mut self, part: &ScanPart<'_>) -> Result<(), Refused> {
        let Some(open) = &mut self.open else {
            return self.unless_synced();
        };
        let known = open.ranges.len() as u32; // at most MOST_BEAMS
        let ranges = part.ranges();
        if part.first != known || ranges.len() > (open.start.beams - known) as usize {
            return Err(INCONSISTENT);
        }
        open.ranges.extend(ranges);
        Ok(())
    }

    fn rows(&mut self, part: &RowsPart<'_>) -> Result<(), Refused> {
        let (Some(open), Some(session)) = (&mut self.open, &self.session) else {
            return self.unless_synced();
        };
        let follows = match open.rows {
            Some(expected) => expected == (part.layer, part.rect, part.start),
            None => part.start == 0,
        };
        let config = &session.config;
        let cells = self.layers.get_mut(part.layer as usize);
        let Some(cells) = cells.filter(|_| follows && open.start.has_maps) else {
            return Err(INCONSISTENT);
        };
        let known = part
            .decode_into(cells, config.width, config.height)
            .ok_or(INCONSISTENT)?;
        let all = part.rect.width() * part.rect.height(); // inside the map
        open.rows = (known < all).then_some((part.layer, part.rect, known));
        if let Some(whole) = open.whole.get_mut(part.layer as usize) {
            *whole |= known as usize == config.cells();
        }
        Ok(())
    }

    /// Outside a tick its frames are only possible while ticks are skipped.
    fn unless_synced(&self) -> Result<(), Refused> {
        if self.is_synced { Err(INCONSISTENT) } else { Ok(()) }
    }

    fn end(&mut self, end: &TickEnd, at: u64, problems: &mut Problems) -> Option<StreamedTick> {
        self.is_session_fresh = false;
        let ended = match &self.open {
            None => self.unless_synced().map(|()| None),
            Some(open) => self.finished(open, end).map(Some),
        };
        match ended {
            Ok(tick) => {
                self.open = None;
                tick
            }
            Err(Refused(kind)) => {
                problems.add(kind, 1, at);
                self.lose();
                None
            }
        }
    }

    /// The tick, if all of it came.
    fn finished(&self, open: &OpenTick, end: &TickEnd) -> Result<StreamedTick, Refused> {
        let session = self.session.as_ref().ok_or(INCONSISTENT)?;
        let start = &open.start;
        let is_complete = open.ranges.len() == start.beams as usize
            && open.rows.is_none()
            && (!start.is_key || open.whole.iter().all(|whole| *whole));
        if !is_complete {
            return Err(INCONSISTENT);
        }
        if !(start.robot.is_finite() && start.sensor.is_finite()) {
            return Err(Refused(ProblemKind::Malformed));
        }
        let [occupancy, costs] = &self.layers;
        if let Some(checksum) = end.checksum {
            let own = MapChecksum {
                occupancy: crc32fast::hash(occupancy),
                costs: crc32fast::hash(costs),
            };
            if own != checksum {
                return Err(Refused(ProblemKind::MapDiffers));
            }
        }
        let maps = start.has_maps.then(|| Layers {
            offset: self.offset,
            occupancy: occupancy.iter().map(|cell| *cell as i8).collect(),
            costs: costs.clone(),
        });
        Ok(StreamedTick {
            session: Arc::clone(session),
            stamp_ns: start.stamp_ns,
            robot: start.robot,
            sensor: start.sensor,
            angle_min: start.angle_min,
            angle_increment: start.angle_increment,
            range_min: start.range_min,
            range_max: start.range_max,
            ranges: open.ranges.clone(),
            maps,
        })
    }
}
