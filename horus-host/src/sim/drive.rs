//! Where the robot is.

use super::circuit::Circuit;
use super::{Pose, World};

/// The robot's drive: again and again through all rooms of a building, at a steady speed along
/// straight lines and arcs, so that its heading is continuous.
#[derive(Debug, Clone)]
pub struct Drive {
    circuit: Circuit,
}

impl Drive {
    /// Speed along the way, in m/s.
    pub const SPEED: f64 = 0.8;
    /// Radius of the robot, in metres. The drive keeps at least 0.25 m from its centre to every
    /// obstacle.
    pub const ROBOT_RADIUS: f64 = 0.25;

    /// The drive through a building.
    pub fn through(world: &World) -> Self {
        Self {
            circuit: world.circuit().clone(),
        }
    }

    /// The robot's pose in the world, `seconds` after it started; theta in -pi..=pi.
    pub fn pose_at(&self, seconds: f64) -> Pose {
        self.circuit.pose(Self::SPEED * seconds)
    }
}
