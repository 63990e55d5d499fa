//! What a local mapping is configured by.

use crate::c_abi::call::Plain;
use crate::c_abi::status::horus_status;
use crate::evidence::{
    BinaryThresholds, FusionOperator, FusionRule, Inpaint, InpaintFrame, Lattice, Masses, SensorConfig,
    SensorModel,
};
use crate::geometry::Pose2D;

/// Most sensors of a local mapping.
pub const HORUS_LOCAL_MAPPING_SENSORS: usize = 4;
/// Most painted rectangles of a local mapping.
pub const HORUS_LOCAL_MAPPING_INPAINTS: usize = 4;

/// How two pieces of evidence about a cell become one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum horus_fusion_operator {
    /// Proportional conflict redistribution; the default.
    Pcr6 = 0,
    /// Dempster's rule of combination.
    DempsterShafer = 1,
    /// Josang's averaging belief fusion: cells that no beam covers forget what they knew.
    JosangAverage = 2,
    /// Josang's cumulative belief fusion.
    JosangCumulative = 3,
}

/// The frame that a painted rectangle lies in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum horus_inpaint_frame {
    /// It moves with the robot.
    Robot = 0,
    /// It stays where it is.
    World = 1,
}

/// Belief masses of a cell, each 0 to 1, their sum at most 1; the rest is uncertain.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct horus_masses {
    /// Belief that the cell is free.
    pub free: f32,
    /// Belief that the cell is occupied.
    pub occupied: f32,
}

/// Where the cells of a grid lie: rows along x, columns along y of the pose of the corner of cell
/// (0, 0).
#[derive(Clone, Copy, Debug, Default)]
#[repr(C)]
pub struct horus_lattice {
    /// Cells along x.
    pub rows: u32,
    /// Cells along y.
    pub cols: u32,
    /// Metres per cell.
    pub cell_size: f32,
    /// Pose of the corner of cell (0, 0) in its frame.
    pub pose: Pose2D,
}

/// A sensor on the robot, and what its beams say.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C)]
pub struct horus_sensor_config {
    /// The cells its scans are turned into, in the robot's frame.
    pub lattice: horus_lattice,
    /// Its pose in the robot's frame.
    pub mount: Pose2D,
    /// Masses of a cell before the hit.
    pub m_free: horus_masses,
    /// Masses of a cell at the hit.
    pub m_occ: horus_masses,
    /// Depth of an obstacle behind the hit, metres.
    pub wall_thickness: f32,
    /// How far a beam that hit nothing frees cells, metres; below 0: the scan's out_of_range_threshold.
    pub max_free_range: f32,
    /// Half the angle of each beam, radians; below 0: half the gaps between beams.
    pub beam_half_width: f32,
}

/// A rectangle whose cells are given masses, whatever the sensors say.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C)]
pub struct horus_inpaint {
    /// A horus_inpaint_frame.
    pub frame: i32,
    /// First x, metres.
    pub x0: f32,
    /// Last x, metres.
    pub x1: f32,
    /// First y, metres.
    pub y0: f32,
    /// Last y, metres.
    pub y1: f32,
    /// What its cells hold.
    pub masses: horus_masses,
}

/// What a local mapping does, stage by stage.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct horus_local_mapping_config {
    /// The window of the fused map in the world; it moves with the robot.
    pub lattice: horus_lattice,
    /// A horus_fusion_operator.
    pub fusion: i32,
    /// Least uncertain mass under Dempster's and Josang's cumulative rule; 0: none.
    pub ignorance_floor: f32,
    /// Least mass free of a free cell.
    pub free_threshold: f32,
    /// Least mass occupied of an occupied cell.
    pub occupied_threshold: f32,
    /// Whether other cells are free (not 0) or occupied (0).
    pub is_optimistic: u32,
    /// Metres at which distances are capped.
    pub max_distance: f32,
    /// Most beams a scan may have.
    pub beams: u32,
    /// Sensors in use; scans name them by index.
    pub sensor_count: u32,
    /// The sensors.
    pub sensors: [horus_sensor_config; HORUS_LOCAL_MAPPING_SENSORS],
    /// Painted rectangles in use, the last one uppermost.
    pub inpaint_count: u32,
    /// The rectangles.
    pub inpaints: [horus_inpaint; HORUS_LOCAL_MAPPING_INPAINTS],
}

// SAFETY: numbers.
unsafe impl Plain for horus_local_mapping_config {}

/// A configuration with the usual numbers, PCR6 and no sensor: set the lattice, the beams and at least
/// one sensor.
#[unsafe(no_mangle)]
pub extern "C" fn horus_local_mapping_config_default() -> horus_local_mapping_config {
    let thresholds = BinaryThresholds::default();
    horus_local_mapping_config {
        lattice: horus_lattice::default(),
        fusion: horus_fusion_operator::Pcr6 as i32,
        ignorance_floor: FusionRule::default().ignorance_floor,
        free_threshold: thresholds.free_threshold,
        occupied_threshold: thresholds.occupied_threshold,
        is_optimistic: 0,
        max_distance: 2.0,
        beams: 0,
        sensor_count: 0,
        sensors: [horus_sensor_config::default(); HORUS_LOCAL_MAPPING_SENSORS],
        inpaint_count: 0,
        inpaints: [horus_inpaint::default(); HORUS_LOCAL_MAPPING_INPAINTS],
    }
}

/// A sensor in the middle of the robot with the usual masses, over a lattice of so many cells around
/// it.
#[unsafe(no_mangle)]
pub extern "C" fn horus_sensor_config_default(rows: u32, cols: u32, cell_size: f32) -> horus_sensor_config {
    let model = SensorModel::default();
    let masses = |m: Masses| horus_masses {
        free: m.free(),
        occupied: m.occupied(),
    };
    horus_sensor_config {
        lattice: horus_lattice_around(rows, cols, cell_size),
        mount: Pose2D::default(),
        m_free: masses(model.m_free),
        m_occ: masses(model.m_occ),
        wall_thickness: model.wall_thickness,
        max_free_range: -1.0,
        beam_half_width: -1.0,
    }
}

/// A lattice with its frame's origin in the middle.
#[unsafe(no_mangle)]
pub extern "C" fn horus_lattice_around(rows: u32, cols: u32, cell_size: f32) -> horus_lattice {
    let half = |cells: u32| cell_size * -0.5 * cells as f32;
    horus_lattice {
        rows,
        cols,
        cell_size,
        pose: Pose2D::new(half(rows), half(cols), 0.0),
    }
}

impl From<horus_lattice> for Lattice {
    fn from(lattice: horus_lattice) -> Self {
        Self {
            rows: lattice.rows,
            cols: lattice.cols,
            cell_size: lattice.cell_size,
            relative_offset: [0.0; 2],
            frame: "",
            pose: lattice.pose,
        }
    }
}

fn masses(masses: horus_masses) -> Result<Masses, horus_status> {
    Ok(Masses::known(masses.free, masses.occupied)?)
}

impl horus_sensor_config {
    fn sensor(&self) -> Result<SensorConfig, horus_status> {
        // NaN is no absence: it is refused as a number would be.
        let unless_negative = |v: f32| if v < 0.0 { None } else { Some(v) };
        Ok(SensorConfig {
            lattice: self.lattice.into(),
            mount: self.mount,
            model: SensorModel {
                m_free: masses(self.m_free)?,
                m_occ: masses(self.m_occ)?,
                wall_thickness: self.wall_thickness,
                max_free_range: unless_negative(self.max_free_range),
                beam_half_width: unless_negative(self.beam_half_width),
            },
        })
    }
}

impl horus_inpaint {
    fn inpaint(&self) -> Result<Inpaint, horus_status> {
        let frame = if self.frame == horus_inpaint_frame::Robot as i32 {
            InpaintFrame::Robot
        } else if self.frame == horus_inpaint_frame::World as i32 {
            InpaintFrame::World
        } else {
            return Err(horus_status::InvalidChoice);
        };
        Ok(Inpaint {
            frame,
            x: [self.x0, self.x1],
            y: [self.y0, self.y1],
            masses: masses(self.masses)?,
        })
    }
}

/// The operator that a number names.
pub(super) fn operator(number: i32) -> Result<FusionOperator, horus_status> {
    let found = FusionOperator::ALL.get(usize::try_from(number).unwrap_or(usize::MAX));
    found.copied().ok_or(horus_status::InvalidChoice)
}

impl horus_local_mapping_config {
    /// The sensors in use.
    pub(super) fn used_sensors(&self) -> Result<&[horus_sensor_config], horus_status> {
        let used = self.sensors.get(..self.sensor_count as usize);
        used.ok_or(horus_status::SizeOverflow)
    }

    /// The sensors, those that are not in use repeating the last.
    pub(super) fn sensors(
        &self,
    ) -> Result<([SensorConfig; HORUS_LOCAL_MAPPING_SENSORS], usize), horus_status> {
        let used = self.used_sensors()?;
        let none = SensorConfig {
            lattice: Lattice::default(),
            mount: Pose2D::default(),
            model: SensorModel::default(),
        };
        let mut sensors = [none; HORUS_LOCAL_MAPPING_SENSORS];
        for (sensor, config) in sensors.iter_mut().zip(used) {
            *sensor = config.sensor()?;
        }
        Ok((sensors, used.len()))
    }

    /// The painted rectangles, and how many are in use.
    pub(super) fn inpaints(&self) -> Result<([Inpaint; HORUS_LOCAL_MAPPING_INPAINTS], usize), horus_status> {
        let used = self.inpaints.get(..self.inpaint_count as usize);
        let used = used.ok_or(horus_status::SizeOverflow)?;
        let none = Inpaint {
            frame: InpaintFrame::Robot,
            x: [0.0; 2],
            y: [0.0; 2],
            masses: Masses::VACUOUS,
        };
        let mut inpaints = [none; HORUS_LOCAL_MAPPING_INPAINTS];
        for (inpaint, config) in inpaints.iter_mut().zip(used) {
            *inpaint = config.inpaint()?;
        }
        Ok((inpaints, used.len()))
    }

    pub(super) fn thresholds(&self) -> BinaryThresholds {
        BinaryThresholds {
            free_threshold: self.free_threshold,
            occupied_threshold: self.occupied_threshold,
            is_optimistic: self.is_optimistic != 0,
        }
    }
}
