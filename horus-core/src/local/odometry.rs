use super::state::{SensingState, Shape, check_name};
use crate::error::Error;
use crate::geometry::Pose2D;

/// An odometry sensor: the robot's pose in a frame that drifts but never jumps.
///
/// Buffers in the [`SensingState`], under its name: `pose` (x, y, theta; metres and radians in the
/// odometry frame) and `twist` (per second, in the robot's frame).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Odometry<'a> {
    /// Its name: the prefix of its buffers.
    pub name: &'a str,
}

const POSE: &str = "pose";
const TWIST: &str = "twist";

impl Odometry<'_> {
    /// Reserves its buffers: two, of three numbers each.
    ///
    /// # Errors
    /// [`Error::NameTooLong`], [`Error::BufferTooSmall`], [`Error::BufferType`]. The state is as it was
    /// then.
    pub fn prepare(&self, state: &mut SensingState<'_>) -> Result<(), Error> {
        check_name(self.name)?;
        state.all_or_nothing(|state| {
            state.reserve::<f32>(self.name, POSE, 3)?;
            state.reserve::<f32>(self.name, TWIST, 3)
        })
    }

    /// Writes a pose and a twist (x, y in metres per second, theta in radians per second).
    ///
    /// # Errors
    /// As [`prepare`](Self::prepare); [`Error::NonFinitePose`]: nothing is written then.
    pub fn write(&self, state: &mut SensingState<'_>, pose: Pose2D, twist: [f32; 3]) -> Result<(), Error> {
        if !pose.is_finite() {
            return Err(Error::NonFinitePose);
        }
        self.prepare(state)?;
        state.write(self.name, POSE, Shape::line(3), &[pose.x, pose.y, pose.theta])?;
        state.write(self.name, TWIST, Shape::line(3), &twist)
    }

    /// The pose that the sensor of this name wrote; `None` if there is none.
    pub fn read_pose(state: &SensingState<'_>, name: &str) -> Option<Pose2D> {
        state.pose(name, POSE)
    }
}
