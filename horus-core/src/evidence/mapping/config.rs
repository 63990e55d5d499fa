use super::super::{BinaryThresholds, FusionRule, Inpaint, Lattice};
use super::SensorConfig;
use crate::error::{Error, Parameter};

/// What a [`LocalMapping`](super::LocalMapping) does, stage by stage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalMappingConfig<'c> {
    /// The window of the fused map, in the world's (odometry's) frame; it moves with the robot.
    pub lattice: Lattice,
    /// How scans are fused with what is known.
    pub rule: FusionRule,
    /// The sensors; scans name them by index.
    pub sensors: &'c [SensorConfig],
    /// Rectangles painted over the fused map, the last one uppermost.
    pub inpaint: &'c [Inpaint],
    /// What is occupied.
    pub thresholds: BinaryThresholds,
    /// Metres at which distances are capped, above 0 and perhaps infinite; in any case they are at what
    /// the map's distance type can hold.
    pub max_distance: f32,
}

impl LocalMappingConfig<'_> {
    /// Checks the numbers.
    ///
    /// # Errors
    /// As those of its parts; [`Error::InvalidParameter`] for a maximum distance that is NaN or not
    /// above zero.
    pub fn validate(&self) -> Result<(), Error> {
        self.lattice.validate()?;
        self.rule.validate()?;
        self.thresholds.validate()?;
        self.sensors.iter().try_for_each(SensorConfig::validate)?;
        self.inpaint.iter().try_for_each(Inpaint::validate)?;
        if self.max_distance > 0.0 {
            Ok(())
        } else {
            Err(Error::InvalidParameter(Parameter::MaxDistance))
        }
    }
}
