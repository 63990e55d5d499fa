use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

use horus_host::log::msg::LaserScan;
use horus_host::log::{LogEntry, LogMessage, LogReader};
use horus_host::tf::{Pose2, TfBuffer, TfError};

use super::map_log::{Frames, MAP_FRAME};
use super::step::{ScanStep, SkipReason, Step};
use super::survey::in_file;

/// The scans of one topic of a log in file order, each with its poses.
pub struct Recording<'a> {
    path: PathBuf,
    reader: LogReader<BufReader<File>>,
    topic: &'a str,
    tf: &'a TfBuffer,
    frames: &'a Frames,
    /// Every how many scans one is used.
    every: u64,
    scans_seen: u64,
    /// The last pose of the odometry frame in the map frame, kept where the log has a hole.
    map_from_odom: Option<Pose2>,
}

impl<'a> Recording<'a> {
    pub fn open(
        path: &Path,
        topic: &'a str,
        tf: &'a TfBuffer,
        frames: &'a Frames,
        every: u64,
    ) -> anyhow::Result<Self> {
        Ok(Self {
            path: path.to_owned(),
            reader: LogReader::open(path).map_err(|error| in_file(path, error))?,
            topic,
            tf,
            frames,
            every,
            scans_seen: 0,
            map_from_odom: None,
        })
    }

    fn step(&mut self, message: &LogMessage) -> anyhow::Result<Step> {
        let mut scan: LaserScan = message.decode().map_err(|error| in_file(&self.path, error))?;
        let has_numbers = scan.angle_min.is_finite()
            && scan.angle_increment.is_finite()
            && !scan.range_min.is_nan()
            && !scan.range_max.is_nan();
        if scan.ranges.is_empty() {
            return Ok(Step::Skipped(SkipReason::Empty));
        }
        if !has_numbers {
            return Ok(Step::Skipped(SkipReason::InvalidFields));
        }
        let Some(stamp_ns) = scan.header.stamp.to_ns() else {
            return Ok(Step::Skipped(SkipReason::InvalidStamp));
        };
        // Frame names are the same with and without leading slashes; ours have none.
        scan.header.frame_id = scan.header.frame_id.trim_start_matches('/').to_owned();
        Ok(match self.locate(stamp_ns, scan) {
            Ok(scan) => Step::Scan(Box::new(scan)),
            Err(error) => Step::Skipped(SkipReason::Transform(error)),
        })
    }

    fn locate(&mut self, stamp_ns: u64, scan: LaserScan) -> Result<ScanStep, TfError> {
        let Frames { odom, base } = self.frames;
        let laser = &scan.header.frame_id;
        let sensor = self.tf.lookup(odom, laser, stamp_ns)?;
        let robot = self.tf.lookup(odom, base, stamp_ns)?;
        let mount = self.tf.lookup(base, laser, stamp_ns)?;
        if let Ok(pose) = self.tf.lookup(MAP_FRAME, odom, stamp_ns) {
            self.map_from_odom = Some(pose);
        }
        Ok(ScanStep {
            stamp_ns,
            scan,
            robot,
            sensor,
            mount,
            map_from_odom: self.map_from_odom,
        })
    }
}

impl Iterator for Recording<'_> {
    type Item = anyhow::Result<Step>;

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            let message = match self.reader.next()? {
                Ok(LogEntry::Message(message)) if message.topic() == self.topic => message,
                Ok(_) => continue,
                Err(error) => return Some(Err(in_file(&self.path, error))),
            };
            self.scans_seen += 1;
            if (self.scans_seen - 1).is_multiple_of(self.every) {
                return Some(self.step(&message));
            }
        }
    }
}
