use std::collections::BTreeMap;

use super::super::Pose2D;
use super::LidarScan;

/// What a named buffer holds, row-major.
#[derive(Debug, Clone, PartialEq)]
pub enum SensingBuffer {
    /// Floats.
    F32(Vec<f32>),
    /// Bytes, in rows of so many.
    U8(Vec<u8>, u32),
}

/// Named buffers between sensors and a map: `name/field`, or `field` for the empty name.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SensingState {
    /// All buffers.
    pub buffers: BTreeMap<String, SensingBuffer>,
}

impl SensingState {
    /// Writes a lidar's scan under its name.
    pub fn write_scan(&mut self, name: &str, scan: &LidarScan) {
        let mount = [scan.mount.x as f32, scan.mount.y as f32, scan.mount.theta as f32];
        self.set(name, "range", &scan.ranges);
        self.set(name, "start_angle", &[scan.start_angle]);
        self.set(name, "fov", &[scan.fov]);
        self.set(name, "max_range", &[scan.max_range]);
        self.set(name, "mount", &mount);
    }

    /// Writes an odometry sensor's pose under its name.
    pub fn write_pose(&mut self, name: &str, pose: Pose2D) {
        self.set(name, "pose", &[pose.x as f32, pose.y as f32, pose.theta as f32]);
    }

    /// A lidar's scan; `None` if a buffer is missing. Without a mounting pose it sits at the robot's centre.
    pub fn read_scan(&self, name: &str) -> Option<LidarScan> {
        let number = |field| self.floats(name, field)?.first().copied();
        Some(LidarScan {
            mount: self.pose(name, "mount").unwrap_or_default(),
            start_angle: number("start_angle")?,
            fov: number("fov")?,
            max_range: number("max_range")?,
            ranges: self.floats(name, "range")?.to_vec(),
        })
    }

    /// The pose of an odometry sensor.
    pub fn read_pose(&self, name: &str) -> Option<Pose2D> {
        self.pose(name, "pose")
    }

    /// The floats of a buffer.
    pub fn floats(&self, name: &str, field: &str) -> Option<&[f32]> {
        match self.buffers.get(&key(name, field))? {
            SensingBuffer::F32(values) => Some(values),
            SensingBuffer::U8(..) => None,
        }
    }

    pub(super) fn set(&mut self, name: &str, field: &str, values: &[f32]) {
        self.buffers
            .insert(key(name, field), SensingBuffer::F32(values.to_vec()));
    }

    pub(super) fn pose(&self, name: &str, field: &str) -> Option<Pose2D> {
        match self.floats(name, field)? {
            &[x, y, theta] => Some(Pose2D::new(x.into(), y.into(), theta.into())),
            _ => None,
        }
    }
}

pub(super) fn key(name: &str, field: &str) -> String {
    match name {
        "" => field.to_owned(),
        _ => format!("{name}/{field}"),
    }
}
