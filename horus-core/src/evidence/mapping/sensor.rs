use super::super::{Flatscan, Lattice, SensorModel};
use crate::error::Error;
use crate::geometry::Pose2D;

/// A sensor on the robot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SensorConfig {
    /// The cells its scans are turned into, in the robot's frame.
    pub lattice: Lattice,
    /// Where it is mounted: its pose in the robot's frame, metres and radians.
    pub mount: Pose2D,
    /// What its beams say.
    pub model: SensorModel,
}

impl SensorConfig {
    /// Checks the numbers.
    ///
    /// # Errors
    /// As [`Lattice::validate`] and [`SensorModel::validate`]; [`Error::NonFinitePose`].
    pub fn validate(&self) -> Result<(), Error> {
        self.lattice.validate()?;
        self.model.validate()?;
        if self.mount.is_finite() {
            Ok(())
        } else {
            Err(Error::NonFinitePose)
        }
    }
}

/// A scan of one of the sensors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SensorScan<'s> {
    /// Index of the sensor.
    pub sensor: usize,
    /// What it saw.
    pub scan: Flatscan<'s>,
}
