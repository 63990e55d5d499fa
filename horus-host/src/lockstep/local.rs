//! Both sides' local maps, and the input they share.

use horus_core::local::BufferSlot;
use horus_core::prelude::{self as core, Lidar, LocalGridMap, LocalGridMapConfig, Odometry, SensingState};

use super::LockstepConfig;
use crate::reference;

/// Names of the sensors.
pub(super) const LIDAR: &str = "lidar";
pub(super) const ODOMETRY: &str = "odom";

/// One tick's input as a local map takes it, rounded once.
pub(super) struct LocalInput {
    pub lidar: Lidar<'static>,
    pub ranges: Vec<f32>,
    pub robot: core::Pose2D,
}

impl LocalInput {
    /// A local map knows no shortest range: what lies below is NaN here; and what a laser scan calls a miss, a
    /// range from the longest on, is +inf.
    pub fn new(scan: &core::LaserScan<'_>, robot: core::Pose2D, sensor: core::Pose2D) -> Self {
        let range = |&range: &f32| {
            if range < scan.range_min {
                f32::NAN
            } else if range >= scan.range_max {
                f32::INFINITY
            } else {
                range
            }
        };
        let gaps = scan.ranges.len().saturating_sub(1);
        Self {
            lidar: Lidar {
                name: LIDAR,
                mount: between(robot, sensor),
                start_angle: scan.angle_min,
                fov: (f64::from(scan.angle_increment) * gaps as f64) as f32,
                max_range: scan.range_max,
            },
            ranges: scan.ranges.iter().map(range).collect(),
            robot,
        }
    }

    /// The std version's sensing state.
    pub fn std_state(&self) -> reference::SensingState {
        let mut state = reference::SensingState::default();
        state.write_pose(ODOMETRY, std_pose(self.robot));
        let scan = reference::LidarScan {
            mount: std_pose(self.lidar.mount),
            start_angle: self.lidar.start_angle,
            fov: self.lidar.fov,
            max_range: self.lidar.max_range,
            ranges: self.ranges.clone(),
        };
        state.write_scan(LIDAR, &scan);
        state
    }
}

/// The core's local map and its sensing state.
pub(super) struct CoreLocal<'a> {
    map: LocalGridMap<'static, &'a mut [u8]>,
    state: SensingState<'a>,
}

impl<'a> CoreLocal<'a> {
    pub fn new(
        config: LocalGridMapConfig<'static>,
        cells: &'a mut [u8],
        (slots, floats): (&'a mut [BufferSlot], &'a mut [f32]),
        beams: usize,
    ) -> Result<Self, core::Error> {
        let mut local = Self {
            map: LocalGridMap::new_in(cells, config)?,
            state: SensingState::new_in(slots, floats, &mut []),
        };
        local.state.reserve::<f32>(LIDAR, "range", beams)?;
        Ok(local)
    }

    pub fn update(
        &mut self,
        input: &LocalInput,
        workspace: &mut core::ScanWorkspace<'_>,
    ) -> Result<reference::LocalUpdate, core::Error> {
        input.lidar.write(&mut self.state, &input.ranges)?;
        let odometry = Odometry { name: ODOMETRY };
        odometry.write(&mut self.state, input.robot, [0.0; 3])?;
        let workspaces = std::slice::from_mut(workspace);
        let update = self.map.update(&self.state, input.robot, workspaces)?;
        Ok(reference::LocalUpdate {
            shift: update.shift,
            missing_odometries: update.missing_odometries,
            lidars: update.lidars,
            missing_lidars: update.missing_lidars,
            empty_lidars: update.empty_lidars,
            invalid_lidars: update.invalid_lidars,
            marks: update.marks,
            ignored: update.ignored,
        })
    }

    pub fn map(&self) -> &LocalGridMap<'static, &'a mut [u8]> {
        &self.map
    }
}

/// The std version's local map of a configuration.
pub(super) fn std_map(
    config: &LockstepConfig,
) -> Result<Option<reference::LocalGridMap>, reference::ReferenceError> {
    let Some(local) = config.local_config() else {
        return Ok(None);
    };
    reference::LocalGridMap::try_new(reference::LocalGridMapConfig {
        width: local.width,
        height: local.height,
        resolution: local.resolution,
        lidars: vec![LIDAR.to_owned()],
        external_odometry: ODOMETRY.to_owned(),
        footprint: match local.footprint {
            core::Footprint::Rectangular => reference::LocalFootprint::Rectangular,
            core::Footprint::Circular => reference::LocalFootprint::Circular,
            core::Footprint::None => reference::LocalFootprint::None,
        },
        radius: local.radius,
        ..reference::LocalGridMapConfig::default()
    })
    .map(Some)
}

/// The sensor's pose on the robot.
fn between(robot: core::Pose2D, sensor: core::Pose2D) -> core::Pose2D {
    let (dx, dy) = (
        f64::from(sensor.x) - f64::from(robot.x),
        f64::from(sensor.y) - f64::from(robot.y),
    );
    let (sin, cos) = libm::sincos(f64::from(robot.theta));
    let turn = f64::from(sensor.theta) - f64::from(robot.theta);
    core::Pose2D::new(
        (cos * dx + sin * dy) as f32,
        (cos * dy - sin * dx) as f32,
        turn as f32,
    )
}

/// Exact: every f32 is an f64.
fn std_pose(pose: core::Pose2D) -> reference::Pose2D {
    reference::Pose2D::new(pose.x.into(), pose.y.into(), pose.theta.into())
}
