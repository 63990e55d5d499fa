use super::state::{SensingState, Shape, check_name};
use crate::error::{Error, Parameter};
use crate::geometry::Pose2D;
use crate::grid::BeamAngles;

/// A planar lidar as navground describes it: `n` beams spread evenly over its field of view.
///
/// Beam `i` of `n` points to `start_angle + i * fov / (n - 1)` radians, counter-clockwise from the
/// sensor's x axis; a single beam points to `start_angle`. Ranges are metres: +inf is a miss at
/// `max_range`; NaN and -inf say nothing.
///
/// Buffers in the [`SensingState`], under its name: `range` (one per beam), `start_angle`, `fov`,
/// `max_range`, and `mount` (x, y, theta), which is ours: a lidar without it sits at the robot's
/// centre.
///
/// # Examples
/// ```
/// use horus_core::prelude::*;
///
/// static FRONT: Lidar = Lidar {
///     name: "front",
///     mount: Pose2D::new(0.1, 0.0, 0.0),
///     start_angle: -1.5,
///     fov: 3.0,
///     max_range: 8.0,
/// };
/// let mut buffers = SensingBuffers::<5, { 360 + 6 }, 0>::empty();
/// let mut state = buffers.state();
/// FRONT.prepare(&mut state, 360)?;
/// FRONT.write(&mut state, &[2.0; 181])?;
/// assert_eq!(state.read::<f32>("front", "range").unwrap().data().len(), 181);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lidar<'a> {
    /// Its name: the prefix of its buffers.
    pub name: &'a str,
    /// Where it sits on the robot: metres and radians in the robot's frame.
    pub mount: Pose2D,
    /// Angle of the first beam in radians.
    pub start_angle: f32,
    /// Angle between the first beam and the last in radians.
    pub fov: f32,
    /// Ranges from 1 mm below this on mark nothing; metres.
    pub max_range: f32,
}

impl Lidar<'_> {
    /// Checks the name and the numbers.
    ///
    /// # Errors
    /// [`Error::NameTooLong`], [`Error::NonFinitePose`], [`Error::InvalidParameter`].
    pub fn validate(&self) -> Result<(), Error> {
        check_name(self.name)?;
        if !self.mount.is_finite() {
            return Err(Error::NonFinitePose);
        }
        let rules = [
            (Parameter::StartAngle, self.start_angle.is_finite()),
            (Parameter::FieldOfView, self.fov.is_finite()),
            (
                Parameter::MaxRange,
                self.max_range.is_finite() && self.max_range >= 0.0,
            ),
        ];
        match rules.iter().find(|(_, valid)| !valid) {
            Some((parameter, _)) => Err(Error::InvalidParameter(*parameter)),
            None => Ok(()),
        }
    }

    /// Reserves its buffers: five, with room for scans of up to `beams` ranges, and six numbers.
    ///
    /// # Errors
    /// As [`validate`](Self::validate); [`Error::BufferTooSmall`], [`Error::BufferType`]. The state is
    /// as it was then.
    pub fn prepare(&self, state: &mut SensingState<'_>, beams: usize) -> Result<(), Error> {
        self.validate()?;
        state.all_or_nothing(|state| {
            state.reserve::<f32>(self.name, RANGE, beams)?;
            for field in [START_ANGLE, FOV, MAX_RANGE] {
                state.reserve::<f32>(self.name, field, 1)?;
            }
            state.reserve::<f32>(self.name, MOUNT, 3)
        })
    }

    /// Writes a scan; one without ranges says that there is none at present. Buffers that were not
    /// [prepared](Self::prepare) are reserved, for scans of this length.
    ///
    /// # Errors
    /// As [`prepare`](Self::prepare).
    ///
    /// # Complexity
    /// One write per range.
    pub fn write(&self, state: &mut SensingState<'_>, ranges: &[f32]) -> Result<(), Error> {
        self.prepare(state, ranges.len())?;
        state.write(self.name, RANGE, Shape::line(ranges.len()), ranges)?;
        for (field, value) in [
            (START_ANGLE, self.start_angle),
            (FOV, self.fov),
            (MAX_RANGE, self.max_range),
        ] {
            state.write(self.name, field, Shape::line(1), &[value])?;
        }
        let mount = [self.mount.x, self.mount.y, self.mount.theta];
        state.write(self.name, MOUNT, Shape::line(3), &mount)
    }
}

const RANGE: &str = "range";
const START_ANGLE: &str = "start_angle";
const FOV: &str = "fov";
const MAX_RANGE: &str = "max_range";
const MOUNT: &str = "mount";

/// A lidar's scan as the state holds it.
#[derive(Clone, Copy, Debug)]
pub(super) struct ScanView<'s> {
    pub mount: Pose2D,
    pub start_angle: f32,
    pub fov: f32,
    pub max_range: f32,
    pub ranges: &'s [f32],
}

impl<'s> ScanView<'s> {
    /// The scan of the lidar of this name; `None` if one of its buffers is missing.
    pub(super) fn read(state: &'s SensingState<'_>, name: &str) -> Option<Self> {
        let number = |field| state.read::<f32>(name, field)?.data().first().copied();
        Some(Self {
            mount: state.pose(name, MOUNT).unwrap_or_default(),
            start_angle: number(START_ANGLE)?,
            fov: number(FOV)?,
            max_range: number(MAX_RANGE)?,
            ranges: state.read(name, RANGE)?.data(),
        })
    }

    /// Whether its numbers, those of an unknown sensor, can be used.
    pub(super) fn is_valid(&self) -> bool {
        let lidar = Lidar {
            name: "",
            mount: self.mount,
            start_angle: self.start_angle,
            fov: self.fov,
            max_range: self.max_range,
        };
        lidar.validate().is_ok()
    }

    pub(super) fn angles(&self) -> BeamAngles {
        let gaps = self.ranges.len().saturating_sub(1).max(1);
        BeamAngles {
            first: self.start_angle,
            span: self.fov,
            parts: u32::try_from(gaps).unwrap_or(u32::MAX),
        }
    }
}
