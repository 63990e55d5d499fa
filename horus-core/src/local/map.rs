use super::frame::Frame;
use super::lidar::ScanView;
use super::{LocalGridMapConfig, LocalUpdate, OCCUPIED, Odometry, PoseSource, SensingState, UNKNOWN, rays};
use crate::error::{Buffer, Error, require};
use crate::geometry::{CELL_LIMIT, GridInfo, Pose2D};
use crate::grid::ScanWorkspace;
use crate::{grid, storage};

/// A rolling map of free, unknown and occupied cells around a robot, over caller-provided storage
/// `S`: one byte per cell.
///
/// Cells are [`FREE`](super::FREE), [`UNKNOWN`](super::UNKNOWN) or [`OCCUPIED`](super::OCCUPIED),
/// row-major, row 0 has the lowest y. The map lies in the frame of the poses it is given, aligned
/// with its axes; its corner is always a whole number of cells from the frame's origin, where it
/// starts.
///
/// RAM: `width * height` bytes, the [`SensingState`]'s buffers, and 12 bytes per beam in the
/// workspaces. A move of the window takes no second map.
///
/// # Examples
/// ```
/// use horus_core::local::{FREE, OCCUPIED};
/// use horus_core::prelude::*;
///
/// let lidar = Lidar { name: "lidar", mount: Pose2D::default(), start_angle: 0.0, fov: 1.0, max_range: 5.0 };
/// let config = LocalGridMapConfig {
///     width: 40,
///     height: 40,
///     radius: 0.2,
///     lidars: &[lidar],
///     ..LocalGridMapConfig::default()
/// };
/// let mut map = LocalGridMap::new_in([0; 40 * 40], config)?;
///
/// let mut buffers = SensingBuffers::<8, 32, 0>::empty(); // `static`s in firmware
/// let mut beams = ScanBuffers::<16, 0>::empty();
/// let mut state = buffers.state();
/// lidar.write(&mut state, &[1.55])?;
/// map.update(&state, Pose2D::new(3.0, 3.0, 0.0), &mut [beams.workspace()])?;
/// assert_eq!(map.value_at(4.55, 3.05), Some(OCCUPIED));
/// assert_eq!(map.value_at(4.0, 3.05), Some(FREE));
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct LocalGridMap<'c, S> {
    config: LocalGridMapConfig<'c>,
    info: GridInfo,
    transformation: Option<Pose2D>,
    cells: S,
}

impl<'c, S: AsRef<[u8]> + AsMut<[u8]>> LocalGridMap<'c, S> {
    /// A map of unknown cells over `cells`, its corner at the frame's origin.
    ///
    /// # Errors
    /// As [`LocalGridMapConfig::validate`]; [`Error::BufferTooSmall`] if `cells` is shorter than
    /// `width * height`.
    ///
    /// # Complexity
    /// One write per cell.
    pub fn new_in(cells: S, config: LocalGridMapConfig<'c>) -> Result<Self, Error> {
        let mut map = Self {
            config,
            info: GridInfo::EMPTY,
            transformation: None,
            cells,
        };
        map.reset(config)?;
        Ok(map)
    }

    /// Starts afresh with another configuration, in place. On an error nothing changes.
    ///
    /// # Errors
    /// As [`new_in`](Self::new_in).
    pub fn reset(&mut self, config: LocalGridMapConfig<'c>) -> Result<(), Error> {
        config.validate()?;
        let info = config.info()?;
        require(Buffer::Cells, info.cells(), self.cells.as_ref().len())?;
        self.config = config;
        self.info = info;
        self.transformation = None;
        self.data_mut().fill(UNKNOWN);
        Ok(())
    }

    /// One update: moves the window by whole cells so that the robot is nearest to its centre (new
    /// cells are unknown), frees the cells under the footprint, and draws the scans in `state`, the
    /// external lidars' first: of each lidar all free rays, then all marks.
    ///
    /// The robot's pose is that of the map's own odometry sensor, else of the external one, else
    /// `pose`. Sensors that are configured but not in the state are skipped and counted, as are scans
    /// without ranges and scans whose numbers are unusable. `pose`, the robot's in the world, also
    /// gives the [transformation](Self::transformation).
    ///
    /// Of every beam the cells from the sensor's to the one a cell's length before its end become
    /// free; the ray is cut at the map's border, first along x, then along y. Its end is marked if
    /// the range is at least 1 cm and more than 1 mm below the longest. +inf clears up to the longest
    /// range, NaN and -inf do nothing. A sensor outside the map frees nothing; its marks count.
    ///
    /// `workspaces` holds one workspace per lidar, in the lidars' order
    /// ([`lidar_names`](LocalGridMapConfig::lidar_names)): it keeps the directions of that lidar's
    /// beams.
    ///
    /// # Errors
    /// [`Error::NonFinitePose`] for the robot's pose or the given one, [`Error::OffsetOutOfRange`];
    /// [`Error::BufferTooSmall`] with fewer workspaces than lidars or one with fewer slots than its
    /// scan has beams. The map is as it was then.
    ///
    /// # Complexity
    /// One read and one write per cell if the window moves; at most `width + height` writes per beam;
    /// trigonometry twice per lidar, and once per beam when a lidar's angles change.
    pub fn update(
        &mut self,
        state: &SensingState<'_>,
        pose: Pose2D,
        workspaces: &mut [ScanWorkspace<'_>],
    ) -> Result<LocalUpdate, Error> {
        let mut update = self.locate(state, pose)?;
        self.check_room(state, workspaces)?;
        update.shift = self.recenter(update.pose)?;
        self.transformation = Some(transformation(pose, update.pose));

        let frame = Frame::new(&self.info);
        let LocalGridMapConfig {
            footprint, radius, ..
        } = self.config;
        let names = self.config.lidar_names();
        let cells = self.data_mut();
        footprint.clear(cells, &frame, update.pose, radius);
        for (name, workspace) in names.zip(workspaces) {
            match ScanView::read(state, name) {
                None => update.missing_lidars += 1,
                Some(scan) if !scan.is_valid() => update.invalid_lidars += 1,
                Some(scan) if scan.ranges.is_empty() => update.empty_lidars += 1,
                Some(scan) => {
                    let drawn = rays::draw(cells, &frame, &scan, update.pose, workspace);
                    update.lidars += 1;
                    update.marks += drawn.marks;
                    update.ignored += drawn.ignored;
                }
            }
        }
        Ok(update)
    }

    /// Moves the window by whole cells so that `pose` is nearest to its centre, ties to even; returns
    /// the cells moved along x and y. Cells keep their contents, new ones are unknown, all of them
    /// after a move of a whole window or more; no move costs nothing.
    ///
    /// # Errors
    /// [`Error::NonFinitePose`]; [`Error::OffsetOutOfRange`] beyond 2^30 cells from the frame's origin.
    /// Nothing changes then.
    ///
    /// # Complexity
    /// One read and one write per cell.
    pub fn recenter(&mut self, pose: Pose2D) -> Result<[i32; 2], Error> {
        if !pose.is_finite() {
            return Err(Error::NonFinitePose);
        }
        let frame = Frame::new(&self.info);
        let along = |p: f32, axis: usize| {
            let cells = frame.shift(p, axis);
            // Also false for NaN: numbers that overflowed.
            (cells.abs() < 2.0 * CELL_LIMIT as f32).then_some(cells as i32)
        };
        let shift = along(pose.x, 0).zip(along(pose.y, 1)).map(|(dx, dy)| [dx, dy]);
        let shift = shift
            .filter(|shift| self.info.can_move(*shift))
            .ok_or(Error::OffsetOutOfRange)?;
        let (width, height) = (self.width(), self.height());
        storage::shift_cells(self.data_mut(), width, height, shift, UNKNOWN);
        self.info.shift_by(shift);
        Ok(shift)
    }

    /// Makes every cell unknown; the window stays where it is.
    pub fn clear(&mut self) {
        self.data_mut().fill(UNKNOWN);
    }

    /// Replaces all cells, row-major: values from 192 on become free, below 64 occupied, the others
    /// unknown.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`] unless `values` has one value per cell; nothing changes then.
    pub fn load(&mut self, values: &[u8]) -> Result<(), Error> {
        let cells = self.data_mut();
        if values.len() != cells.len() {
            return Err(Error::LengthMismatch {
                needed: cells.len(),
                given: values.len(),
            });
        }
        for (cell, value) in cells.iter_mut().zip(values) {
            *cell = match value {
                ..64 => OCCUPIED,
                64..192 => UNKNOWN,
                192.. => super::FREE,
            };
        }
        Ok(())
    }

    /// The pose of an update, and where it came from.
    fn locate(&self, state: &SensingState<'_>, given: Pose2D) -> Result<LocalUpdate, Error> {
        let own = self.config.odometry.map(|odometry| odometry.name);
        let external = Some(self.config.external_odometry).filter(|name| !name.is_empty());
        let mut update = LocalUpdate {
            shift: [0; 2],
            pose: given,
            source: PoseSource::Given,
            missing_odometries: 0,
            lidars: 0,
            missing_lidars: 0,
            empty_lidars: 0,
            invalid_lidars: 0,
            marks: 0,
            ignored: 0,
        };
        for (name, source) in [
            (own, PoseSource::Odometry),
            (external, PoseSource::ExternalOdometry),
        ] {
            match name.map(|name| Odometry::read_pose(state, name)) {
                Some(Some(pose)) => {
                    (update.pose, update.source) = (pose, source);
                    break;
                }
                Some(None) => update.missing_odometries += 1,
                None => {}
            }
        }
        if update.pose.is_finite() && given.is_finite() {
            Ok(update)
        } else {
            Err(Error::NonFinitePose)
        }
    }

    /// An error unless every lidar has a workspace with room for its scan.
    fn check_room(&self, state: &SensingState<'_>, workspaces: &[ScanWorkspace<'_>]) -> Result<(), Error> {
        let lidars = self.config.external_lidars.len() + self.config.lidars.len();
        require(Buffer::Workspaces, lidars, workspaces.len())?;
        for (name, workspace) in self.config.lidar_names().zip(workspaces) {
            let beams = ScanView::read(state, name).map_or(0, |scan| scan.ranges.len());
            require(Buffer::Beams, beams, workspace.beams())?;
        }
        Ok(())
    }

    fn data_mut(&mut self) -> &mut [u8] {
        let n = self.info.cells();
        self.cells.as_mut().get_mut(..n).unwrap_or_default()
    }
}

impl<'c, S: AsRef<[u8]>> LocalGridMap<'c, S> {
    /// What the map was made from.
    pub const fn config(&self) -> &LocalGridMapConfig<'c> {
        &self.config
    }

    /// Size, resolution and place; its first origin is that of the frame. Its queries of points use
    /// the boundary rule of occupancy grids; those of this map are [`cell_at`](Self::cell_at) and
    /// [`value_at`](Self::value_at).
    pub const fn info(&self) -> &GridInfo {
        &self.info
    }

    /// Columns.
    pub const fn width(&self) -> u32 {
        self.info.width()
    }

    /// Rows.
    pub const fn height(&self) -> u32 {
        self.info.height()
    }

    /// Metres per cell.
    pub const fn resolution(&self) -> f32 {
        self.info.resolution()
    }

    /// Whole cells from the frame's origin to the corner of cell (0, 0).
    pub const fn offset(&self) -> [i32; 2] {
        self.info.offset()
    }

    /// The corner of cell (0, 0) in metres in the map's frame: offset times resolution.
    pub fn origin(&self) -> [f32; 2] {
        self.info
            .offset()
            .map(|cells| cells as f32 * self.info.resolution())
    }

    /// All cells, row-major.
    pub fn data(&self) -> &[u8] {
        self.cells.as_ref().get(..self.info.cells()).unwrap_or_default()
    }

    /// A cell's value; outside the map: `None`.
    pub fn value(&self, gx: u32, gy: u32) -> Option<u8> {
        self.data().get(self.info.index(gx, gy)?).copied()
    }

    /// The cell that holds a point (metres in the map's frame); outside the map, NaN or infinite:
    /// `None`. As navground rounds: towards the map's corner, plainly in f32.
    pub fn cell_at(&self, x: f32, y: f32) -> Option<(u32, u32)> {
        let (cx, cy) = Frame::new(&self.info).cell(x, y)?;
        Some((cx as u32, cy as u32))
    }

    /// The value of the cell that holds a point (metres in the map's frame); outside: `None`.
    pub fn value_at(&self, x: f32, y: f32) -> Option<u8> {
        let (gx, gy) = self.cell_at(x, y)?;
        self.value(gx, gy)
    }

    /// A cell as an occupancy grid has it: 0 free, 100 occupied, -1 unknown; outside: `None`.
    pub fn occupancy(&self, gx: u32, gy: u32) -> Option<i8> {
        self.value(gx, gy).map(occupancy_of)
    }

    /// All cells as an occupancy grid has them, row-major, without a copy.
    pub fn occupancies(&self) -> impl ExactSizeIterator<Item = i8> + '_ {
        self.data().iter().map(|value| occupancy_of(*value))
    }

    /// The transformation from the map's frame to the world (metres, radians) as of the last update:
    /// the given pose after the inverse of the odometry's. Identity without odometry; `None` before
    /// the first update.
    pub const fn transformation(&self) -> Option<Pose2D> {
        self.transformation
    }
}

/// A local map's value in the terms of occupancy grids.
pub(super) const fn occupancy_of(value: u8) -> i8 {
    match value {
        OCCUPIED => grid::OCCUPIED,
        super::FREE => grid::FREE,
        _ => grid::UNKNOWN,
    }
}

/// `world * odom^-1`, its heading within a turn of 0 where those of the poses are.
fn transformation(world: Pose2D, odom: Pose2D) -> Pose2D {
    use core::f32::consts::{PI, TAU};
    let theta = world.theta - odom.theta;
    let theta = if theta > PI {
        theta - TAU
    } else if theta < -PI {
        theta + TAU
    } else {
        theta
    };
    let (c, s) = crate::math::cos_sin(theta);
    Pose2D::new(
        world.x - (c * odom.x - s * odom.y),
        world.y - (s * odom.x + c * odom.y),
        theta,
    )
}
