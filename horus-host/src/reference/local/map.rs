use super::super::{Pose2D, ReferenceError};
use super::draw::draw;
use super::frame::LocalFrame;
use super::state::key;
use super::{FREE, LocalGridMapConfig, LocalUpdate, SensingBuffer, SensingState, UNKNOWN};

/// A rolling map of free (255), unknown (128) and occupied (0) cells around a robot, aligned with the axes of the
/// frame that its poses lie in.
#[derive(Debug, Clone, PartialEq)]
pub struct LocalGridMap {
    /// Cells, row-major, row 0 at the lowest y.
    pub data: Vec<u8>,
    config: LocalGridMapConfig,
    offset: [i32; 2],
    transformation: Option<Pose2D>,
}

impl LocalGridMap {
    /// An unknown map with the corner of cell (0, 0) at the frame's origin.
    ///
    /// # Errors
    /// As [`LocalGridMapConfig::validate`]; a size that memory does not hold.
    pub fn try_new(config: LocalGridMapConfig) -> Result<Self, ReferenceError> {
        config.validate()?;
        let (width, height) = (config.width, config.height);
        let too_large = ReferenceError::GridSize { width, height };
        if width.max(height) > 1 << 30 {
            return Err(too_large);
        }
        let cells = usize::try_from(u64::from(width) * u64::from(height)).or(Err(too_large))?;
        let mut data = Vec::new();
        data.try_reserve_exact(cells).or(Err(too_large))?;
        data.resize(cells, UNKNOWN);
        Ok(Self {
            data,
            config,
            offset: [0, 0],
            transformation: None,
        })
    }

    /// One update: recentre, free the footprint, then draw every lidar's scan. `pose` is the robot's in the world; it
    /// is also its pose in the map where no odometry is in the state.
    ///
    /// # Errors
    /// A pose that is not finite, a window more than 2^30 cells from the frame's origin: nothing has changed then.
    pub fn update(&mut self, state: &SensingState, pose: Pose2D) -> Result<LocalUpdate, ReferenceError> {
        let mut update = LocalUpdate::default();
        let external = Some(&self.config.external_odometry).filter(|name| !name.is_empty());
        let mut odom = None;
        for name in self.config.odometry.iter().chain(external) {
            odom = odom.or_else(|| {
                let pose = state.read_pose(name);
                update.missing_odometries += u32::from(pose.is_none());
                pose
            });
        }
        let odom = odom.unwrap_or(pose);
        pose.to_f32().ok_or(ReferenceError::Pose("pose in the world"))?;
        let robot = odom.to_f32().ok_or(ReferenceError::Pose("robot's pose"))?;
        update.shift = self.recenter(odom)?;
        self.transformation = Some(transformation(pose, odom));

        let frame = self.frame();
        for gy in 0..self.config.height {
            for gx in 0..self.config.width {
                let footprint = self.config.footprint;
                if footprint.covers(&frame, [robot[0], robot[1]], self.config.radius, [gx, gy]) {
                    self.data[(gy * self.config.width + gx) as usize] = FREE;
                }
            }
        }
        for name in &self.config.lidars {
            match state.read_scan(name) {
                None => update.missing_lidars += 1,
                Some(scan) if scan.validate().is_err() => update.invalid_lidars += 1,
                Some(scan) if scan.ranges.is_empty() => update.empty_lidars += 1,
                Some(scan) => {
                    update.lidars += 1;
                    draw(&mut self.data, &frame, &scan, robot, &mut update)?;
                }
            }
        }
        Ok(update)
    }

    /// Moves the window by whole cells to have `pose` nearest to its middle; new cells are unknown.
    ///
    /// # Errors
    /// As [`update`](Self::update).
    pub fn recenter(&mut self, pose: Pose2D) -> Result<[i32; 2], ReferenceError> {
        let [x, y, _] = pose.to_f32().ok_or(ReferenceError::Pose("pose to recenter on"))?;
        let frame = self.frame();
        let shift = [frame.shift(x, 0), frame.shift(y, 1)];
        let limit = f32::from_bits(0x4f00_0000); // 2^31
        if shift.iter().any(|cells| cells.is_nan() || cells.abs() >= limit) {
            return Err(ReferenceError::WindowOffset);
        }
        let shift = shift.map(|cells| cells as i64);
        let moved = [0, 1].map(|axis| i64::from(self.offset[axis]) + shift[axis]);
        if moved.iter().any(|cells| cells.abs() > 1 << 30) {
            return Err(ReferenceError::WindowOffset);
        }
        let [width, height] = frame.size.map(i64::from);
        let before = self.data.clone();
        for gy in 0..height {
            for gx in 0..width {
                let (x, y) = (gx + shift[0], gy + shift[1]);
                let inside = (0..width).contains(&x) && (0..height).contains(&y);
                self.data[(gy * width + gx) as usize] = if inside {
                    before[(y * width + x) as usize]
                } else {
                    UNKNOWN
                };
            }
        }
        self.offset = moved.map(|cells| cells as i32);
        Ok(shift.map(|cells| cells as i32))
    }

    /// What the map was made from.
    pub fn config(&self) -> &LocalGridMapConfig {
        &self.config
    }

    /// Whole cells from the frame's origin to the corner of cell (0, 0).
    pub fn offset(&self) -> [i32; 2] {
        self.offset
    }

    /// The corner of cell (0, 0) in metres.
    pub fn origin(&self) -> [f32; 2] {
        [self.frame().low(0), self.frame().low(1)]
    }

    /// The transformation from the map's frame to the world as of the last update.
    pub fn transformation(&self) -> Option<Pose2D> {
        self.transformation
    }

    /// The cells as an occupancy grid has them: 0 free, 100 occupied, -1 unknown.
    pub fn occupancies(&self) -> Vec<i8> {
        let occupancy = |&value: &u8| match value {
            super::OCCUPIED => 100,
            FREE => 0,
            _ => -1,
        };
        self.data.iter().map(occupancy).collect()
    }

    /// Writes the map's outputs under its name.
    pub fn publish(&self, state: &mut SensingState) {
        let name = &self.config.name;
        let map = SensingBuffer::U8(self.data.clone(), self.config.width);
        state.buffers.insert(key(name, "local_gridmap"), map);
        state.set(name, "origin", &self.origin());
        state.set(name, "resolution", &[self.config.resolution]);
        if let Some(pose) = self.transformation.filter(|_| self.config.include_transformation) {
            let pose = [pose.x as f32, pose.y as f32, pose.theta as f32];
            state.set(name, "transformation", &pose);
        }
    }

    /// The cells that were published under a name.
    pub fn read_gridmap_with_name<'s>(state: &'s SensingState, name: &str) -> Option<&'s [u8]> {
        match state.buffers.get(&key(name, "local_gridmap"))? {
            SensingBuffer::U8(cells, _) => Some(cells),
            SensingBuffer::F32(_) => None,
        }
    }

    /// The transformation that was published under a name.
    pub fn read_transformation_with_name(state: &SensingState, name: &str) -> Option<Pose2D> {
        state.pose(name, "transformation")
    }

    fn frame(&self) -> LocalFrame {
        LocalFrame {
            resolution: self.config.resolution,
            size: [self.config.width, self.config.height],
            offset: self.offset,
        }
    }
}

/// `world * odom^-1`, heading within half a turn.
fn transformation(world: Pose2D, odom: Pose2D) -> Pose2D {
    let (sin, cos) = libm::sincos(world.theta - odom.theta);
    Pose2D::new(
        world.x - (cos * odom.x - sin * odom.y),
        world.y - (sin * odom.x + cos * odom.y),
        libm::atan2(sin, cos),
    )
}
