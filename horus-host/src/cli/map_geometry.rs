use horus_core::prelude::Pose2D;
use horus_host::lockstep::LockstepConfig;
use horus_host::tf::Pose2;

/// Size and place of a rolling map, and its lethal cost: what logs and pictures need of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MapGeometry {
    pub width: u32,
    pub height: u32,
    pub resolution: f32,
    /// Pose of the corner of cell (0, 0) before the window first moved.
    pub origin: Pose2D,
    pub lethal_cost: u8,
}

impl MapGeometry {
    /// The map of a configuration, with its corner elsewhere.
    pub fn with_origin(config: &LockstepConfig, origin: Pose2D) -> Self {
        Self {
            width: config.width,
            height: config.height,
            resolution: config.resolution,
            origin,
            lethal_cost: config.params.lethal_cost,
        }
    }

    /// Pose of the corner of cell (0, 0) once the window has moved by `offset` whole cells.
    pub fn corner(&self, offset: [i32; 2]) -> Pose2 {
        let metres = offset.map(|cells| f64::from(cells) * f64::from(self.resolution));
        let yaw = f64::from(self.origin.theta);
        let (sin, cos) = libm::sincos(yaw);
        Pose2 {
            x: f64::from(self.origin.x) + (cos * metres[0] - sin * metres[1]),
            y: f64::from(self.origin.y) + (sin * metres[0] + cos * metres[1]),
            yaw,
        }
    }
}

impl From<&LockstepConfig> for MapGeometry {
    fn from(config: &LockstepConfig) -> Self {
        Self::with_origin(config, config.origin())
    }
}
