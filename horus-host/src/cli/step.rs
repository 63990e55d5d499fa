use horus_host::log::msg::LaserScan;
use horus_host::tf::{Pose2, TfError};

/// What a source of scans yields, one per scan.
#[derive(Debug)]
pub enum Step {
    Scan(Box<ScanStep>),
    Skipped(SkipReason),
}

/// A scan, and where everything was when it was taken.
#[derive(Debug)]
pub struct ScanStep {
    pub stamp_ns: u64,
    pub scan: LaserScan,
    /// Of the robot in the frame of the map.
    pub robot: Pose2,
    /// Of the sensor in the frame of the map.
    pub sensor: Pose2,
    /// Of the sensor on the robot.
    pub mount: Pose2,
    /// Of the map's frame in the frame `map`; `None` if the two are one or nothing is known.
    pub map_from_odom: Option<Pose2>,
}

/// Why a scan could not be used.
#[derive(Debug)]
pub enum SkipReason {
    /// It has no ranges.
    Empty,
    /// Its angles or range limits are no numbers.
    InvalidFields,
    /// Its time lies before the epoch.
    InvalidStamp,
    /// The transforms give no pose for it.
    Transform(TfError),
    /// Its pose is not finite in 32-bit floats, or the maps refused it for another reason.
    Refused(String),
}

impl SkipReason {
    /// A name for counting.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Empty => "empty",
            Self::InvalidFields => "invalid_fields",
            Self::InvalidStamp => "invalid_stamp",
            Self::Transform(TfError::UnknownFrame { .. }) => "tf_unknown_frame",
            Self::Transform(TfError::Disconnected { .. }) => "tf_disconnected",
            Self::Transform(TfError::Extrapolation { .. }) => "tf_extrapolation",
            Self::Transform(TfError::Gap { .. }) => "tf_gap",
            Self::Transform(_) => "tf_other",
            Self::Refused(_) => "refused",
        }
    }

    /// The reason in words.
    pub fn sentence(&self) -> String {
        match self {
            Self::Empty => "the scan has no ranges".into(),
            Self::InvalidFields => "an angle or range limit of the scan is not a number".into(),
            Self::InvalidStamp => "the scan's time lies before the epoch".into(),
            Self::Transform(error) => error.to_string(),
            Self::Refused(reason) => reason.clone(),
        }
    }
}
