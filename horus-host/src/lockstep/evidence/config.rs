use horus_core::distance::MAX_SIDE;
use horus_core::evidence::{BinaryThresholds, FusionOperator, FusionRule, Lattice, SensorModel};
use horus_core::prelude::{Error, Pose2D};

use crate::lockstep::{LockstepConfig, LockstepError};
use crate::reference::evidence as std_version;

/// The maps that both sides keep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EvidenceConfig {
    /// Columns of the fused map, and rows of the sensor's lattice.
    pub width: u32,
    /// Rows of the fused map, and columns of the sensor's lattice.
    pub height: u32,
    /// Metres per cell of both.
    pub resolution: f32,
    /// How scans are fused.
    pub rule: FusionRule,
    /// What the sensor's beams say.
    pub model: SensorModel,
    /// What is occupied.
    pub thresholds: BinaryThresholds,
    /// Metres at which distances are capped.
    pub max_distance: f32,
}

impl Default for EvidenceConfig {
    /// 200 x 200 cells of 0.05 m, PCR6, optimistic, distances up to 2 m.
    fn default() -> Self {
        Self {
            width: 200,
            height: 200,
            resolution: 0.05,
            rule: FusionRule::default(),
            model: SensorModel::default(),
            thresholds: BinaryThresholds {
                is_optimistic: true,
                ..BinaryThresholds::default()
            },
            max_distance: 2.0,
        }
    }
}

impl EvidenceConfig {
    /// Checks size and parameters.
    ///
    /// # Errors
    /// [`LockstepError::Size`]; [`LockstepError::Core`] with the core's reason.
    pub fn validate(&self) -> Result<(), LockstepError> {
        let size = LockstepConfig {
            width: self.width,
            height: self.height,
            resolution: self.resolution,
            ..LockstepConfig::default()
        };
        size.validate()?;
        if self.width.max(self.height) > MAX_SIDE {
            return Err(LockstepError::Side {
                width: self.width,
                height: self.height,
                most: MAX_SIDE,
            });
        }
        self.rule.validate()?;
        self.model.validate()?;
        self.thresholds.validate()?;
        Ok(())
    }

    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.width as usize * self.height as usize
    }

    /// Largest difference of a mass between the sides that is no mismatch, over any number of ticks: 5e-3 for the rules
    /// that forget their errors, 1e-2 for the two that the ignorance floor keeps from growing theirs.
    pub fn bound(&self) -> f64 {
        match self.rule.operator {
            FusionOperator::Pcr6 | FusionOperator::JosangAverage => 5e-3,
            FusionOperator::DempsterShafer | FusionOperator::JosangCumulative => 1e-2,
        }
    }

    /// A lattice of the maps' size with its frame's origin in the middle.
    pub(super) fn lattice(&self, frame: &'static str) -> Result<Lattice, Error> {
        Lattice::new(self.width, self.height, self.resolution, [-0.5, -0.5], frame)
    }

    /// The same for the std version, with the lattices that core made.
    pub(super) fn std(&self, lattice: &Lattice, mount: Pose2D) -> std_version::LocalMappingConfig {
        let masses = |m: horus_core::evidence::Masses| {
            std_version::Masses::known(f64::from(m.free()), f64::from(m.occupied()))
        };
        let lattice = std_version::Lattice {
            rows: lattice.rows,
            cols: lattice.cols,
            cell_size: lattice.cell_size,
            pose: [lattice.pose.x, lattice.pose.y, lattice.pose.theta],
        };
        std_version::LocalMappingConfig {
            lattice,
            operator: match self.rule.operator {
                FusionOperator::Pcr6 => std_version::FusionOperator::Pcr6,
                FusionOperator::DempsterShafer => std_version::FusionOperator::DempsterShafer,
                FusionOperator::JosangAverage => std_version::FusionOperator::JosangAverage,
                FusionOperator::JosangCumulative => std_version::FusionOperator::JosangCumulative,
            },
            ignorance_floor: f64::from(self.rule.ignorance_floor),
            sensors: vec![std_version::Sensor {
                lattice,
                mount: [mount.x, mount.y, mount.theta],
                model: std_version::SensorModel {
                    m_free: masses(self.model.m_free),
                    m_occ: masses(self.model.m_occ),
                    wall_thickness: self.model.wall_thickness,
                    max_free_range: self.model.max_free_range,
                    beam_half_width: self.model.beam_half_width,
                },
            }],
            inpaint: Vec::new(),
            thresholds: std_version::BinaryThresholds {
                free_threshold: f64::from(self.thresholds.free_threshold),
                occupied_threshold: f64::from(self.thresholds.occupied_threshold),
                is_optimistic: self.thresholds.is_optimistic,
            },
        }
    }
}
