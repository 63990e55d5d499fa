use super::super::ReferenceError;
use super::LocalFootprint;

/// What a local map is made from, with navground's defaults.
#[derive(Debug, Clone, PartialEq)]
pub struct LocalGridMapConfig {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Metres per cell.
    pub resolution: f32,
    /// Whether the outputs include the transformation from the map's frame to the world.
    pub include_transformation: bool,
    /// Lidars in the order in which they are drawn: the external ones, then the map's own.
    pub lidars: Vec<String>,
    /// The map's own odometry sensor.
    pub odometry: Option<String>,
    /// The odometry sensor that others own; empty: none.
    pub external_odometry: String,
    /// What is freed around the robot.
    pub footprint: LocalFootprint,
    /// Radius of the footprint in metres.
    pub radius: f32,
    /// Prefix of the outputs.
    pub name: String,
}

impl Default for LocalGridMapConfig {
    fn default() -> Self {
        Self {
            width: 10,
            height: 10,
            resolution: 0.1,
            include_transformation: false,
            lidars: Vec::new(),
            odometry: None,
            external_odometry: String::new(),
            footprint: LocalFootprint::Rectangular,
            radius: 0.0,
            name: String::new(),
        }
    }
}

impl LocalGridMapConfig {
    /// Checks everything but the map's size.
    ///
    /// # Errors
    /// A resolution that is not finite and above zero, a radius that is not finite or negative, a name of more than
    /// 32 bytes, two lidars with the same name.
    pub fn validate(&self) -> Result<(), ReferenceError> {
        if !(self.resolution.is_finite() && self.resolution > 0.0) {
            return Err(ReferenceError::Resolution(self.resolution));
        }
        if !(self.radius.is_finite() && self.radius >= 0.0) {
            let (name, expected) = ("radius", "finite and not negative");
            return Err(ReferenceError::LocalMap { name, expected });
        }
        let names = [&self.name, &self.external_odometry].into_iter();
        if names
            .chain(&self.odometry)
            .chain(&self.lidars)
            .any(|name| name.len() > 32)
        {
            let (name, expected) = ("a name", "at most 32 bytes long");
            return Err(ReferenceError::LocalMap { name, expected });
        }
        let repeats = |(i, name): (usize, &String)| self.lidars[..i].contains(name);
        if self.lidars.iter().enumerate().any(repeats) {
            return Err(ReferenceError::DuplicateLidar);
        }
        Ok(())
    }
}
