use horus_core::frames::Session;
use horus_core::prelude::{GridInfo, Pose2D};

use crate::lockstep::LockstepConfig;

/// What a sender told about its map and robot.
#[derive(Debug, Clone, PartialEq)]
pub struct StreamSession {
    /// Size and parameters of the map; the sender does not tell whether it keeps its costs.
    pub config: LockstepConfig,
    /// Pose of the corner of cell (0, 0) in the map's frame before the window first moved.
    pub origin: Pose2D,
    /// The lidar on the robot, metres and radians.
    pub mount: Pose2D,
    /// The frame the map lies in.
    pub odom: String,
    /// The robot's frame.
    pub base: String,
    /// The lidar's frame.
    pub sensor: String,
}

impl StreamSession {
    /// The session in a frame; `None` if no map can be like that, or has more than `most_cells`.
    pub(super) fn new(session: &Session<'_>, most_cells: usize) -> Option<Self> {
        let config = LockstepConfig {
            width: session.width,
            height: session.height,
            resolution: session.resolution,
            params: session.params,
            model: session.model,
            keep_costs: false,
            local: None,
        };
        config.validate().ok()?;
        GridInfo::new(config.width, config.height, config.resolution, session.origin).ok()?;
        // As everywhere here, frame names have no leading slashes.
        let name = |name: &str| {
            let name = name.trim_start_matches('/');
            let is_usable = !name.is_empty() && !name.contains('\0');
            is_usable.then(|| name.to_owned())
        };
        let is_possible = config.cells() <= most_cells && session.mount.is_finite();
        Some(Self {
            config,
            origin: session.origin,
            mount: session.mount,
            odom: name(session.names.odom)?,
            base: name(session.names.base)?,
            sensor: name(session.names.sensor)?,
        })
        .filter(|_| is_possible)
    }
}
