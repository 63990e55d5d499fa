use super::crc::Crc32;
use super::pending::Pending;
use super::{FrameNames, FrameWriter, MapChecksum, Session, TickEnd, TickStart};
use crate::costmap::{CostMap, CostParams, FieldCell};
use crate::error::Error;
use crate::geometry::{CellRect, Pose2D};
use crate::grid::{LaserScan, ScanModel};

/// What a [`MapStream`] tells about the robot, and how often it sends what.
#[derive(Clone, Copy, Debug)]
pub struct StreamOptions<'a> {
    /// How scans change cells.
    pub model: ScanModel,
    /// The lidar on the robot, metres and radians.
    pub mount: Pose2D,
    /// Names of the coordinate frames.
    pub names: FrameNames<'a>,
    /// Every how many ticks the whole map is sent; 0: with the first tick and on request only.
    pub key_every: u32,
    /// Every how many ticks the map's changes are sent; 0 counts as 1.
    pub maps_every: u32,
    /// Every how many maps a checksum of the whole map is sent, by which the listener sees that
    /// its copy differs; 0: never.
    pub checksum_every: u32,
}

impl Default for StreamOptions<'_> {
    /// Model `Set`, the lidar in the middle of the robot, the names of [`FrameNames`]; maps with
    /// every tick, all of it and a checksum with every 64th.
    fn default() -> Self {
        Self {
            model: ScanModel::Set,
            mount: Pose2D::default(),
            names: FrameNames::default(),
            key_every: 64,
            maps_every: 1,
            checksum_every: 64,
        }
    }
}

/// What happened in one tick, as it was handed to the map.
#[derive(Clone, Copy, Debug)]
pub struct StreamTick<'a> {
    /// Time of the scan, nanoseconds since the epoch its user keeps.
    pub stamp_ns: u64,
    /// The robot, as given to [`CostMap::recenter`]. For a log that replays to the same bytes its
    /// heading lies in -pi..=pi, and the sensor is the robot times the mounting pose.
    pub robot: Pose2D,
    /// The lidar, as given to [`CostMap::integrate_scan`].
    pub sensor: Pose2D,
    /// The scan.
    pub scan: LaserScan<'a>,
    /// Every cell whose occupancy differs from the last tick lies in here
    /// ([`ScanReport::changed`](crate::grid::ScanReport)), but for what the window's motion did.
    pub changed: Option<CellRect>,
    /// What [`CostMap::update_costs`] or [`CostMap::update_costs_within`] returned.
    pub costs_changed: Option<CellRect>,
}

/// Streams a cost map, its scans and poses as frames: one call per tick, after the update.
///
/// Each tick's frames hold what changed; every [`key_every`](StreamOptions::key_every) ticks, after
/// [`request_key`](Self::request_key) and when the map's parameters have changed, the whole map.
///
/// # Examples
/// ```
/// use horus_core::costmap::bit_words;
/// use horus_core::frames::{MapStream, StreamOptions, StreamTick};
/// use horus_core::prelude::*;
///
/// # let mut buffers = CostMapBuffers::<{ 40 * 40 }, { bit_words(40, 40) }>::empty();
/// # let (cells, cost_buffers) = buffers.split();
/// # let grid = OccupancyGrid::new_in(cells, 40, 40, 0.05, Pose2D::new(-1.0, -1.0, 0.0))?;
/// # let mut map = CostMap::new_in(grid, cost_buffers, CostParams::default())?;
/// # let mut lidar = ScanBuffers::<4, 0>::empty();
/// # let mut lidar = lidar.workspace();
/// let mut sent = 0;
/// let mut buffer = [0; 512];
/// let uart = |frame: &[u8]| sent += frame.len(); // here: hand it to the UART
/// let mut stream = MapStream::new_in(&mut buffer, uart, StreamOptions::default())?;
///
/// let pose = Pose2D::new(0.1, 0.0, 0.0);
/// let scan = LaserScan { angle_min: 0.0, angle_increment: 1.57, range_min: 0.1, range_max: 8.0, ranges: &[0.5; 4] };
/// map.recenter(pose)?;
/// let report = map.integrate_scan(&scan, pose, ScanModel::Set, &mut lidar)?;
/// let costs_changed = map.update_costs();
/// let changed = report.changed;
/// stream.tick(&map, &StreamTick { stamp_ns: 0, robot: pose, sensor: pose, scan, changed, costs_changed });
/// assert!(sent < 500);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug)]
pub struct MapStream<'b, S> {
    frames: FrameWriter<'b, S>,
    options: StreamOptions<'b>,
    /// Ticks since the last key tick, and since the last with a map; maps since the last checksum.
    since: [u32; 3],
    /// The map's parameters and offset with the last tick; `None`: a key tick is due.
    last: Option<(CostParams, [i32; 2])>,
    occupancy: Pending,
    costs: Pending,
}

impl<'b, S: FnMut(&[u8])> MapStream<'b, S> {
    /// A stream that builds frames in `buffer`, of [`MIN_BUFFER`](super::MIN_BUFFER) bytes or more.
    ///
    /// # Errors
    /// [`Error::BufferTooSmall`].
    pub fn new_in(buffer: &'b mut [u8], sink: S, options: StreamOptions<'b>) -> Result<Self, Error> {
        Ok(Self {
            frames: FrameWriter::new_in(buffer, sink)?,
            options,
            since: [0; 3],
            last: None,
            occupancy: Pending::default(),
            costs: Pending::default(),
        })
    }

    /// Sends the whole map with the next tick: when a listener asks for it, or after
    /// [`CostMap::load`] and other changes that no tick tells of.
    pub fn request_key(&mut self) {
        self.last = None;
    }

    /// Frames written so far, modulo 2^32.
    pub fn frames(&self) -> u32 {
        self.frames.frames()
    }

    /// What the frames go to.
    pub fn sink_mut(&mut self) -> &mut S {
        self.frames.sink_mut()
    }

    /// Sends a tick. Call it once per tick, in order, also where the map's changes are sent less
    /// often. Whether the tick was a key tick.
    ///
    /// # Complexity
    /// Four bytes per beam; two reads per cell in the rectangles that changed, of both maps; for a
    /// checksum one read per cell of both.
    pub fn tick<F: FieldCell>(&mut self, map: &CostMap<'_, F>, tick: &StreamTick<'_>) -> bool {
        let info = map.info();
        let is_key = self.is_key_due(map.params());
        let has_maps = is_key || self.since[1].saturating_add(1) >= self.options.maps_every;
        self.follow(map, tick);
        if is_key {
            let options = &self.options;
            self.frames
                .session(&Session::of(map, options.model, options.mount, options.names));
        }
        self.frames.tick_start(&TickStart {
            is_key,
            has_maps,
            stamp_ns: tick.stamp_ns,
            robot: tick.robot,
            sensor: tick.sensor,
            offset: info.offset(),
            beams: tick.scan.ranges.len() as u32,
            angle_min: tick.scan.angle_min,
            angle_increment: tick.scan.angle_increment,
            range_min: tick.scan.range_min,
            range_max: tick.scan.range_max,
        });
        self.frames.ranges(tick.scan.ranges);
        let mut checksum = None;
        if has_maps {
            if is_key {
                self.occupancy.add(Some(whole(map)));
                self.costs.add(Some(whole(map)));
            }
            if let Some(rect) = self.occupancy.take() {
                self.frames.occupancy(map.occupancy_grid(), rect);
            }
            if let Some(rect) = self.costs.take() {
                self.frames.costs(map, rect);
            }
            let due = self.since[2].saturating_add(1) >= self.options.checksum_every;
            checksum = (due && self.options.checksum_every > 0).then(|| checksum_of(map));
        }
        self.frames.tick_end(TickEnd { checksum });
        let count = |since: &mut u32, reset: bool| *since = if reset { 0 } else { since.saturating_add(1) };
        let [keys, maps, checksums] = &mut self.since;
        count(keys, is_key);
        count(maps, has_maps);
        if has_maps {
            count(checksums, checksum.is_some());
        }
        is_key
    }

    fn is_key_due(&self, params: &CostParams) -> bool {
        let is_periodic =
            self.options.key_every > 0 && self.since[0].saturating_add(1) >= self.options.key_every;
        is_periodic || self.last.is_none_or(|(last, _)| last != *params)
    }

    /// Adds a tick's changes to those that wait.
    fn follow<F: FieldCell>(&mut self, map: &CostMap<'_, F>, tick: &StreamTick<'_>) {
        let offset = map.info().offset();
        let last = self.last.replace((*map.params(), offset));
        let shift = last.map_or([0; 2], |(_, last)| {
            [offset[0].wrapping_sub(last[0]), offset[1].wrapping_sub(last[1])]
        });
        self.occupancy.shift(shift);
        self.costs.shift(shift);
        self.occupancy.add(tick.changed);
        // The base cost of a changed cell shows at once, also where a budgeted update has not
        // come to it.
        self.costs.add(tick.changed);
        self.costs.add(tick.costs_changed);
        if shift != [0; 2] {
            self.costs.add(Some(whole(map)));
        }
    }
}

fn whole<F: FieldCell>(map: &CostMap<'_, F>) -> CellRect {
    CellRect {
        x0: 0,
        y0: 0,
        x1: map.info().width(),
        y1: map.info().height(),
    }
}

fn checksum_of<F: FieldCell>(map: &CostMap<'_, F>) -> MapChecksum {
    let cells = map.occupancy_grid().data().iter().map(|cell| *cell as u8);
    let costs = match map.costs() {
        Some(kept) => Crc32::of(kept.iter().copied()),
        None => Crc32::of((0..map.info().height()).flat_map(|gy| map.row(gy))),
    };
    MapChecksum {
        occupancy: Crc32::of(cells),
        costs,
    }
}
