use super::super::post::Decision;
use super::super::viewpoint::Viewpoint;
use super::super::{
    BeamLimits, BinaryMap, EvidenceFusion, EvidenceU16, FusionReport, MassCell, Masses, SensorGrid, Tally,
    class_bytes,
};
use super::{LocalMappingConfig, MappingBuffers, SensorScan};
use crate::error::{Buffer, Error, require};
use crate::geometry::{GridInfo, Pose2D};

/// The whole of Isaac's local mapping as one object that a control loop ticks: scans become evidence,
/// are fused into a rolling map, which is painted over, cut into free and occupied, and measured for
/// distances.
///
/// Every stage stays readable after a tick. Sensors tick at their own rates: a tick fuses the scans
/// that it is given, in the order of the slice.
#[derive(Debug)]
pub struct LocalMapping<'a, M: MassCell = EvidenceU16> {
    config: LocalMappingConfig<'a>,
    fusion: EvidenceFusion<'a, M>,
    classes: &'a mut [u8],
    limits: &'a mut [BeamLimits],
    binary: BinaryMap<'a>,
    decision: Decision<M>,
    /// The robot in the world.
    robot: Viewpoint,
}

/// What a tick did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TickReport {
    /// Whole cells by which the window moved along x and y.
    pub shift: [i32; 2],
    /// What the fusions met, all scans together.
    pub fusion: FusionReport,
}

impl<'a, M: MassCell> LocalMapping<'a, M> {
    /// A map that knows nothing, with the world's origin where the lattice puts it.
    ///
    /// # Errors
    /// As [`LocalMappingConfig::validate`] and [`EvidenceFusion::new_in`]; [`Error::BufferTooSmall`].
    ///
    /// # Complexity
    /// One write per cell and stage.
    pub fn new_in(buffers: MappingBuffers<'a, M>, config: LocalMappingConfig<'a>) -> Result<Self, Error> {
        config.validate()?;
        let MappingBuffers {
            cells,
            classes,
            limits,
            binary,
        } = buffers;
        let most = config
            .sensors
            .iter()
            .map(|s| class_bytes(s.lattice.rows, s.lattice.cols));
        require(Buffer::Classes, most.max().unwrap_or(0), classes.len())?;
        let fusion = EvidenceFusion::new_in(cells, config.lattice, config.rule)?;
        let mut mapping = Self {
            fusion,
            classes,
            limits,
            binary: BinaryMap::new_in(binary, config.lattice.rows, config.lattice.cols)?,
            decision: Decision::new(config.thresholds)?,
            robot: Viewpoint::new(Pose2D::default()),
            config,
        };
        mapping.finish();
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
    /// Per scan one arc tangent per sensor cell and one fusion per cell of the map that is not vacuous.
    pub fn tick(&mut self, scans: &[SensorScan<'_>], robot: Pose2D) -> Result<TickReport, Error> {
        self.check(scans, robot)?;
        let shift = self.fusion.recenter(robot)?;
        self.robot = Viewpoint::new(robot);
        let mut tally = Tally::default();
        for SensorScan { sensor, scan } in scans {
            let sensor = self
                .config
                .sensors
                .get(*sensor)
                .ok_or(Error::UnknownSensor(*sensor))?;
            let mut grid = SensorGrid::new_in(self.classes, sensor.lattice, sensor.model)?;
            grid.project(scan, sensor.mount, self.limits)?;
            tally.add(self.fusion.tally(&grid, robot)?);
        }
        self.finish();
        Ok(TickReport {
            shift,
            fusion: tally.report::<M>(),
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

    /// The stages after the fusion.
    fn finish(&mut self) {
        self.binary.fill(self.fusion.cells(), &self.decision);
        for inpaint in self.config.inpaint {
            let occupied = self.decision.is_occupied(M::from_masses(inpaint.masses));
            let binary = &mut self.binary;
            inpaint
                .placed(self.fusion.info(), &self.robot)
                .for_each(|gx, gy| binary.set(gx, gy, occupied));
        }
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
    /// Complexity: constant, plus one comparison per painted rectangle.
    pub fn inpainted_at(&self, gx: u32, gy: u32) -> Option<Masses> {
        let masses = self.fusion.masses_at(gx, gy)?;
        let mut over = self.config.inpaint.iter().rev();
        let over = over.find(|inpaint| inpaint.placed(self.info(), &self.robot).holds(gx, gy));
        Some(over.map_or(masses, |inpaint| M::from_masses(inpaint.masses).masses()))
    }

    /// The binary map.
    pub const fn binary(&self) -> &BinaryMap<'a> {
        &self.binary
    }
}
