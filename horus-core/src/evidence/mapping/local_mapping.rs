use super::super::post::Decision;
use super::super::viewpoint::Viewpoint;
use super::super::{
    BeamLimits, BinaryMap, EvidenceFusion, EvidenceU16, FusionReport, MassCell, Masses, ScanClass,
    SensorGrid, Tally, binary_to_distance, class_at, class_bytes,
};
use super::{LocalMappingConfig, MappingBuffers, SensorScan};
use crate::distance::{DistanceCell, DistanceMap};
use crate::error::{Buffer, Error, require};
use crate::geometry::{GridInfo, Pose2D};

/// The whole of Isaac's local mapping as one object that a control loop ticks: scans become evidence,
/// are fused into a rolling map, which is painted over, cut into free and occupied, and measured for
/// distances.
///
/// Every stage stays readable after a tick. Sensors tick at their own rates: a tick fuses the scans
/// that it is given, in the order of the slice. `M` is the type of mass cells; `D` that of distances:
/// signed (`i16`, `i32`) is Isaac's `compute_distance_inside`.
///
/// # Examples
/// ```
/// use horus_core::evidence::*;
/// use horus_core::prelude::Pose2D;
/// use horus_core::storage::bitmap_words;
///
/// const SIDE: u32 = 64;
/// type Buffers = LocalMappingBuffers<
///     { (SIDE * SIDE) as usize },
///     { class_bytes(SIDE, SIDE) },
///     { bitmap_words(SIDE, SIDE) },
///     5,
///     { SIDE as usize },
/// >;
/// let lidar = SensorConfig {
///     lattice: Lattice::new(SIDE, SIDE, 0.05, [-0.5, -0.5], "robot")?,
///     mount: Pose2D::new(0.1, 0.0, 0.0),
///     model: SensorModel::default(),
/// };
/// let config = LocalMappingConfig {
///     lattice: Lattice::new(SIDE, SIDE, 0.05, [-0.5, -0.5], "odom")?,
///     rule: FusionRule::new("pcr6".parse()?),
///     sensors: &[lidar],
///     inpaint: &[],
///     thresholds: BinaryThresholds { is_optimistic: true, ..BinaryThresholds::default() },
///     max_distance: 2.0,
/// };
/// let mut buffers = Buffers::empty(); // a `static` in firmware
/// let mut mapping = LocalMapping::new_in(buffers.split(), config)?;
///
/// let scan = Flatscan {
///     angles: &[-0.2, -0.1, 0.0, 0.1, 0.2],
///     ranges: &[1.0; 5],
///     invalid_range_threshold: 0.05,
///     out_of_range_threshold: 8.0,
///     visibilities: None,
/// };
/// mapping.tick(&[SensorScan { sensor: 0, scan }], Pose2D::default())?;
/// assert_eq!(mapping.binary().is_occupied(54, 32), Some(true)); // 1.1 m ahead
/// let metres = mapping.distance().metres_at(34, 32).unwrap_or_default();
/// assert!((0.95..=1.0).contains(&metres));
/// # Ok::<(), horus_core::Error>(())
/// ```
#[derive(Debug)]
pub struct LocalMapping<'a, M: MassCell = EvidenceU16, D: DistanceCell = u16> {
    config: LocalMappingConfig<'a>,
    fusion: EvidenceFusion<'a, M>,
    classes: &'a mut [u8],
    limits: &'a mut [BeamLimits],
    binary: BinaryMap<'a>,
    decision: Decision<M>,
    distance: DistanceMap<'a, D>,
    /// The window that the distances are of.
    distance_info: GridInfo,
    /// The robot in the world.
    robot: Viewpoint,
    last_sensor: Option<usize>,
}

/// What a tick did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TickReport {
    /// Whole cells by which the window moved along x and y.
    pub shift: [i32; 2],
    /// What the fusions met, all scans together.
    pub fusion: FusionReport,
    /// Rows of distances that still wait; 0: they can be read.
    pub distance_rows_left: u32,
}

impl<'a, M: MassCell, D: DistanceCell> LocalMapping<'a, M, D> {
    /// A map that knows nothing, with the world's origin where the lattice puts it.
    ///
    /// # Errors
    /// As [`LocalMappingConfig::validate`] and [`EvidenceFusion::new_in`]; [`Error::SizeOverflow`] if
    /// a side exceeds [`MAX_SIDE`](crate::distance::MAX_SIDE); [`Error::BufferTooSmall`].
    ///
    /// # Complexity
    /// One write per cell and stage.
    pub fn new_in(buffers: MappingBuffers<'a, M, D>, config: LocalMappingConfig<'a>) -> Result<Self, Error> {
        config.validate()?;
        let MappingBuffers {
            cells,
            classes,
            limits,
            binary,
            distance,
        } = buffers;
        let lattices = config.sensors.iter().map(|sensor| sensor.lattice);
        let most = lattices.map(|lattice| class_bytes(lattice.rows, lattice.cols));
        require(Buffer::Classes, most.max().unwrap_or(0), classes.len())?;
        let fusion = EvidenceFusion::new_in(cells, config.lattice, config.rule)?;
        let mut mapping = Self {
            distance_info: *fusion.info(),
            fusion,
            classes,
            limits,
            binary: BinaryMap::new_in(binary, config.lattice.rows, config.lattice.cols)?,
            decision: Decision::new(config.thresholds)?,
            distance: DistanceMap::new_in(distance),
            robot: Viewpoint::new(Pose2D::default()),
            last_sensor: None,
            config,
        };
        mapping.cut();
        mapping.begin_distance()?;
        mapping.distance.advance(u32::MAX);
        Ok(mapping)
    }

    /// One tick of the whole chain: moves the window to the robot, turns each scan into evidence and
    /// fuses it, then paints, cuts and measures. `robot` is odometry: the robot's pose in the world.
    ///
    /// # Errors
    /// [`Error::NonFinitePose`], [`Error::OffsetOutOfRange`]; for the scans [`Error::UnknownSensor`],
    /// [`Error::SensorOutsideMap`], [`Error::EmptyScan`], [`Error::InvalidScan`],
    /// [`Error::LengthMismatch`], [`Error::BufferTooSmall`] for more beams than there are limits.
    /// Nothing has changed then.
    ///
    /// # Complexity
    /// Per scan one arc tangent per sensor cell and one fusion per cell of the map that is not vacuous;
    /// distances as [`DistanceMap::compute`].
    pub fn tick(&mut self, scans: &[SensorScan<'_>], robot: Pose2D) -> Result<TickReport, Error> {
        // What an earlier tick left of its distances is of no use.
        self.run(scans, robot, u32::MAX, true)
    }

    /// As [`tick`](Self::tick), but does at most `rows` rows of the distance stage, of which a map takes
    /// 2 * height. A stage once begun is finished over the next ticks before another begins, so that
    /// distances are those of an earlier tick; [`distance_info`](Self::distance_info) tells where.
    ///
    /// # Errors
    /// As [`tick`](Self::tick).
    ///
    /// # Complexity
    /// As [`tick`](Self::tick) for the other stages; two cell visits per cell in a tick that begins the
    /// distance stage, and [`DistanceMap::advance`] of `rows`.
    pub fn tick_within(
        &mut self,
        scans: &[SensorScan<'_>],
        robot: Pose2D,
        rows: u32,
    ) -> Result<TickReport, Error> {
        self.run(scans, robot, rows, false)
    }

    fn run(
        &mut self,
        scans: &[SensorScan<'_>],
        robot: Pose2D,
        rows: u32,
        anew: bool,
    ) -> Result<TickReport, Error> {
        self.check(scans, robot)?;
        let shift = self.fusion.recenter(robot)?;
        self.robot = Viewpoint::new(robot);
        let mut tally = Tally::default();
        for SensorScan { sensor: index, scan } in scans {
            let sensor = self
                .config
                .sensors
                .get(*index)
                .ok_or(Error::UnknownSensor(*index))?;
            self.last_sensor = Some(*index);
            let mut grid = SensorGrid::new_in(self.classes, sensor.lattice, sensor.model)?;
            grid.project(scan, sensor.mount, self.limits)?;
            tally.add(self.fusion.tally(&grid, robot)?);
        }
        self.cut();
        if anew || self.distance.advance(0) == 0 {
            self.begin_distance()?;
        }
        Ok(TickReport {
            shift,
            fusion: tally.report::<M>(),
            distance_rows_left: self.distance.advance(rows),
        })
    }

    /// Everything that a tick could stumble over.
    fn check(&self, scans: &[SensorScan<'_>], robot: Pose2D) -> Result<(), Error> {
        let mut info = *self.fusion.info();
        info.shift_by(info.shift_to(robot)?);
        let frame = Viewpoint::new(robot);
        for SensorScan { sensor: index, scan } in scans {
            let sensor = self
                .config
                .sensors
                .get(*index)
                .ok_or(Error::UnknownSensor(*index))?;
            scan.validate()?;
            sensor.model.check_beams(scan.angles.len())?;
            require(Buffer::Beams, scan.angles.len(), self.limits.len())?;
            let (x, y) = frame.point((sensor.mount.x, sensor.mount.y));
            if info.world_to_grid(x, y).is_none() {
                return Err(Error::SensorOutsideMap(*index));
            }
        }
        Ok(())
    }

    /// Cuts the map, painted over, into free and occupied.
    fn cut(&mut self) {
        self.binary.fill(self.fusion.cells(), &self.decision);
        for inpaint in self.config.inpaint {
            let occupied = self.decision.is_occupied(M::from_masses(inpaint.masses));
            let binary = &mut self.binary;
            inpaint
                .placed(self.fusion.info(), &self.robot)
                .for_each(|gx, gy| binary.set(gx, gy, occupied));
        }
    }

    fn begin_distance(&mut self) -> Result<(), Error> {
        let (resolution, max_distance) = (self.config.lattice.cell_size, self.config.max_distance);
        binary_to_distance(&self.binary, resolution, max_distance, &mut self.distance)?;
        self.distance_info = *self.fusion.info();
        Ok(())
    }

    /// What it does.
    pub const fn config(&self) -> &LocalMappingConfig<'a> {
        &self.config
    }

    /// Size, resolution and place of the window.
    pub const fn info(&self) -> &GridInfo {
        self.fusion.info()
    }

    /// The fused map, before painting.
    pub const fn evidence(&self) -> &EvidenceFusion<'a, M> {
        &self.fusion
    }

    /// The masses of a cell after painting; outside the window: `None`.
    ///
    /// # Complexity
    /// Constant, plus one comparison per painted rectangle.
    pub fn inpainted_at(&self, gx: u32, gy: u32) -> Option<Masses> {
        let masses = self.fusion.masses_at(gx, gy)?;
        let mut over = self.config.inpaint.iter().rev();
        let over = over.find(|inpaint| inpaint.placed(self.info(), &self.robot).holds(gx, gy));
        Some(over.map_or(masses, |inpaint| M::from_masses(inpaint.masses).masses()))
    }

    /// The binary map of the last tick.
    pub const fn binary(&self) -> &BinaryMap<'a> {
        &self.binary
    }

    /// The distances; nothing can be read of them while a stage begun by
    /// [`tick_within`](Self::tick_within) has not ended.
    pub const fn distance(&self) -> &DistanceMap<'a, D> {
        &self.distance
    }

    /// The window that the distances are of.
    pub const fn distance_info(&self) -> &GridInfo {
        &self.distance_info
    }

    /// What the scan that was fused last says about a cell of its sensor's lattice; outside, and before
    /// the first scan: vacuous.
    pub fn class_at(&self, row: u32, col: u32) -> ScanClass {
        let lattice = self
            .last_sensor
            .and_then(|i| self.config.sensors.get(i))
            .map(|sensor| sensor.lattice);
        lattice.map_or(ScanClass::Vacuous, |lattice| {
            class_at(self.classes, &lattice, row, col)
        })
    }

    /// Index of the sensor whose scan was fused last.
    pub const fn last_sensor(&self) -> Option<usize> {
        self.last_sensor
    }
}
