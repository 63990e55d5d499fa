use std::collections::BTreeMap;
use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use horus_host::lockstep::Layers;
use horus_host::log::msg::{Header, TFMessage, Transform, TransformStamped};
use horus_host::log::{LogError, LogWriter};
use horus_host::tf::Pose2;

use super::map_geometry::MapGeometry;
use super::step::ScanStep;
use super::survey::in_file;

/// Root of the frames in the logs we write.
pub const MAP_FRAME: &str = "map";

/// Headings are written as whole multiples of this, in radians: 2^44 of them to one. A quaternion that
/// is read back then gives the same heading, so that a replay of a log writes the same bytes again.
const HEADING_STEPS: f64 = (1u64 << 44) as f64;

/// Scans between two flushes: what a crash can cost.
const SCANS_PER_FLUSH: u32 = 64;

/// What logs are written with.
pub type Writer = LogWriter<BufWriter<File>>;

/// The frames a run works in, without leading slashes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Frames {
    /// The frame the map lies in.
    pub odom: String,
    /// The robot.
    pub base: String,
}

/// The log of one side: scans, transforms and that side's maps.
pub struct MapLog {
    path: PathBuf,
    writer: Writer,
    map: MapGeometry,
    frames: Frames,
    /// Sensor frame and mounting pose as last written.
    mount: Option<(String, Pose2)>,
    unflushed: u32,
}

impl MapLog {
    /// Starts the log at `path` with a `horus` metadata record.
    pub fn create(
        path: &Path,
        map: MapGeometry,
        frames: &Frames,
        metadata: BTreeMap<String, String>,
    ) -> anyhow::Result<Self> {
        let start = || {
            let mut writer = LogWriter::create(path)?;
            writer.set_flush_interval(0);
            writer.metadata("horus", metadata)?;
            Ok(writer)
        };
        Ok(Self {
            path: path.to_owned(),
            writer: start().map_err(|error| in_file(path, error))?,
            map,
            frames: frames.clone(),
            mount: None,
            unflushed: 0,
        })
    }

    /// Goes on with another map, told by another `horus` metadata record.
    pub fn change_map(
        &mut self,
        map: MapGeometry,
        frames: &Frames,
        metadata: BTreeMap<String, String>,
    ) -> anyhow::Result<()> {
        (self.map, self.frames) = (map, frames.clone());
        let written = self.writer.metadata("horus", metadata);
        written.map_err(|error| in_file(&self.path, error))
    }

    /// Writes a scan and the transforms that connect it, and with `layers` the maps after it.
    pub fn write(&mut self, step: &ScanStep, layers: Option<&Layers>) -> anyhow::Result<()> {
        let (map, frame) = (self.map, self.frames.odom.clone());
        self.write_with(step, |writer| match layers {
            Some(layers) => write_maps(writer, &map, &frame, step.stamp_ns, layers),
            None => Ok(()),
        })
    }

    /// Writes a scan and the transforms that connect it, then what `maps` writes.
    pub fn write_with(
        &mut self,
        step: &ScanStep,
        maps: impl FnOnce(&mut Writer) -> Result<(), LogError>,
    ) -> anyhow::Result<()> {
        let written = self.write_step(step, maps);
        written.map_err(|error| in_file(&self.path, error))
    }

    /// Writes index and footer.
    pub fn finish(self) -> anyhow::Result<PathBuf> {
        self.writer.finish().map_err(|error| in_file(&self.path, error))?;
        Ok(self.path)
    }

    fn write_step(
        &mut self,
        step: &ScanStep,
        maps: impl FnOnce(&mut Writer) -> Result<(), LogError>,
    ) -> Result<(), LogError> {
        let (stamp_ns, laser) = (step.stamp_ns, &step.scan.header.frame_id);
        let mount = Some((laser.clone(), step.mount));
        if self.mount != mount && *laser != self.frames.base {
            let message = TFMessage {
                transforms: vec![transform(stamp_ns, &self.frames.base, laser, step.mount)],
            };
            self.writer.write("/tf_static", stamp_ns, &message)?;
            self.mount = mount;
        }
        let Frames { odom, base } = &self.frames;
        let mut transforms = vec![transform(stamp_ns, odom, base, step.robot)];
        if odom != MAP_FRAME {
            let identity = Pose2 {
                x: 0.0,
                y: 0.0,
                yaw: 0.0,
            };
            let pose = step.map_from_odom.unwrap_or(identity);
            transforms.insert(0, transform(stamp_ns, MAP_FRAME, odom, pose));
        }
        self.writer.write("/tf", stamp_ns, &TFMessage { transforms })?;
        if !step.scan.ranges.is_empty() {
            self.writer.write("/scan", stamp_ns, &step.scan)?;
        }
        maps(&mut self.writer)?;
        self.unflushed += 1;
        if self.unflushed >= SCANS_PER_FLUSH {
            self.unflushed = 0;
            self.writer.flush()?;
        }
        Ok(())
    }
}

fn write_maps(
    writer: &mut Writer,
    map: &MapGeometry,
    frame: &str,
    stamp_ns: u64,
    layers: &Layers,
) -> Result<(), LogError> {
    let header = Header::new(stamp_ns, frame);
    let map = map.at(layers.offset);
    let occupancy = map.occupancy_grid(header.clone(), layers.occupancy.clone());
    writer.write("/local_map", stamp_ns, &occupancy)?;
    let viewable = map.viewable(header.clone(), &layers.costs);
    writer.write("/costmap", stamp_ns, &viewable)?;
    let exact = map.costmap(header, layers.costs.clone());
    writer.write("/costmap_raw", stamp_ns, &exact)
}

fn transform(stamp_ns: u64, parent: &str, child: &str, pose: Pose2) -> TransformStamped {
    TransformStamped {
        header: Header::new(stamp_ns, parent),
        child_frame_id: child.to_owned(),
        transform: Transform::planar(pose.x, pose.y, (pose.yaw * HEADING_STEPS).round() / HEADING_STEPS),
    }
}
