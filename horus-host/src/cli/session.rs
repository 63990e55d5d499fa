use std::fmt::Display;
use std::path::PathBuf;

use horus_core::prelude as core;
use horus_host::lockstep::{CoreStorage, Layers, Lockstep, LockstepConfig};
use horus_host::picture::{Cells, Picture, Rgb, palette};
use horus_host::tf::Pose2;
use indicatif::ProgressBar;
use serde::Serialize;

use super::map_geometry::MapGeometry;
use super::map_log::{Frames, MapLog};
use super::out_dir::OutDir;
use super::report;
use super::skipped::Skipped;
use super::step::{ScanStep, SkipReason, Step};
use super::summary::{FirstMismatch, Storage, Summary, metadata};
use super::verdict::Verdict;

/// Files that a run leaves in its output directory besides pictures and summary.
pub const LOG_NAMES: [&str; 2] = ["core.mcap", "std.mcap"];

/// Pictures are enlarged up to this many pixels on their longer side.
pub const PICTURE_SIZE: u32 = 800;
/// Colour and radius (in metres) of the robot in pictures.
const ROBOT: (Rgb, f64) = (Rgb([0, 0xa0, 0x40]), 0.15);

/// A lockstep run over scans from anywhere, and where its results go.
pub struct Session<'a> {
    pub config: LockstepConfig,
    pub frames: &'a Frames,
    /// Most beams of a scan.
    pub beams: usize,
    pub out: Option<&'a OutDir>,
    /// Every how many scans the maps are logged.
    pub log_every: u64,
    /// Most scans to use.
    pub limit: u64,
}

impl Session<'_> {
    /// Runs all scans through both sides; writes logs and pictures, not the summary.
    pub fn run(
        &self,
        source: String,
        steps: impl Iterator<Item = anyhow::Result<Step>>,
        bar: &ProgressBar,
    ) -> anyhow::Result<Summary> {
        let mut storage = CoreStorage::new(&self.config, self.beams)?;
        let facts = Storage::from(&storage);
        let mut lockstep = Lockstep::new(&self.config, &mut storage)?;
        let mut logs: Option<[MapLog; 2]> = None;
        let mut skipped = Skipped::default();
        let mut last: Option<(u64, Pose2)> = None;
        let mut out_of_order = 0;

        for step in steps {
            bar.inc(1);
            let step = match step? {
                Step::Scan(step) => step,
                Step::Skipped(reason) => {
                    skipped.add(&reason);
                    continue;
                }
            };
            let (robot, sensor) = (rounded(step.robot), rounded(step.sensor));
            if !(robot.is_finite() && sensor.is_finite()) {
                skipped.add(&SkipReason::Refused(
                    "a pose is not finite in 32-bit floats".into(),
                ));
                continue;
            }
            let refusal = lockstep.tick(step.stamp_ns, &core_scan(&step), robot, sensor);
            if let Some(reason) = refusal {
                skipped.add(&SkipReason::Refused(reason));
            }
            out_of_order += u64::from(last.is_some_and(|(stamp_ns, _)| step.stamp_ns < stamp_ns));
            last = Some((step.stamp_ns, step.robot));
            if let Some(out) = self.out {
                let logs = match &mut logs {
                    Some(logs) => logs,
                    none => none.insert(self.start_logs(out)?),
                };
                let due = (lockstep.totals().ticks - 1).is_multiple_of(self.log_every);
                let layers = [lockstep.core_layers(), lockstep.std_layers()];
                for (log, layers) in logs.iter_mut().zip(layers) {
                    log.write(&step, due.then_some(layers))?;
                }
            }
            if lockstep.totals().ticks >= self.limit {
                break;
            }
        }
        bar.finish_and_clear();

        let mut summary = Summary::new(source, &self.config, &facts, lockstep.totals());
        summary.skipped_scans = skipped.total();
        summary.skipped = skipped;
        summary.out_of_order_scans = out_of_order;
        summary.first_mismatch = lockstep.first_mismatch().map(FirstMismatch::from);
        for log in logs.into_iter().flatten() {
            summary.files.push(log.finish()?);
        }
        if let (Some(out), Some((_, robot))) = (self.out, last) {
            let layers = [lockstep.core_layers(), lockstep.std_layers()];
            summary.files.extend(self.paint(out, layers, robot)?);
        }
        Ok(summary)
    }

    fn start_logs(&self, out: &OutDir) -> anyhow::Result<[MapLog; 2]> {
        let start = |name: &str, side: &str| {
            let metadata = metadata(&self.config, &self.frames.odom, side);
            MapLog::create(
                &out.file(name),
                MapGeometry::from(&self.config),
                self.frames,
                metadata,
            )
        };
        let [core, std] = LOG_NAMES;
        Ok([start(core, "core")?, start(std, "std")?])
    }

    /// Paints the core's map after the last scan, and core minus std version.
    fn paint(&self, out: &OutDir, [core, std]: [&Layers; 2], robot: Pose2) -> anyhow::Result<Vec<PathBuf>> {
        let LockstepConfig {
            width,
            height,
            resolution,
            params,
            ..
        } = self.config;
        let scale = (PICTURE_SIZE / width.max(height)).clamp(1, 16);
        let costs = Cells::new(width, height, &core.costs)?;
        let mut occupancy = Picture::paint(
            Cells::new(width, height, &core.occupancy)?,
            scale,
            palette::occupancy,
        )?;
        let mut costmap = Picture::paint(costs, scale, |cost| palette::cost(cost, params.lethal_cost))?;
        let difference = Picture::paint_difference(costs, Cells::new(width, height, &std.costs)?, scale)?;
        let corner = MapGeometry::from(&self.config).corner(core.offset);
        let cells = |metres: f64| metres / f64::from(resolution);
        for picture in [&mut occupancy, &mut costmap] {
            let (gx, gy) = (cells(robot.x - corner.x), cells(robot.y - corner.y));
            picture.mark_robot(gx, gy, robot.yaw, cells(ROBOT.1), ROBOT.0);
        }
        [
            ("occupancy.png", occupancy),
            ("costmap.png", costmap),
            ("difference.png", difference),
        ]
        .into_iter()
        .map(|(name, picture)| out.replace(name, |path| Ok(picture.save(path)?)))
        .collect()
    }
}

/// A result that `summary.json` and the screen tell.
pub trait Told: Serialize + Display {
    fn mismatches(&self) -> u64;
    fn files(&mut self) -> &mut Vec<PathBuf>;
}

impl Told for Summary {
    fn mismatches(&self) -> u64 {
        self.mismatches
    }

    fn files(&mut self) -> &mut Vec<PathBuf> {
        &mut self.files
    }
}

/// Writes `summary.json` where there is an output directory, and prints the result.
pub fn conclude(mut summary: impl Told, out: Option<&OutDir>, json: bool) -> anyhow::Result<Verdict> {
    if let Some(out) = out {
        let name = "summary.json";
        summary.files().push(out.file(name));
        out.replace_text(name, &format!("{}\n", report::to_json(&summary)?))?;
    }
    report::print(&summary, &summary, json)?;
    Ok(if summary.mismatches() == 0 {
        Verdict::Equal
    } else {
        Verdict::Different
    })
}

/// The one rounding of a pose: both sides get this one.
pub fn rounded(pose: Pose2) -> core::Pose2D {
    core::Pose2D::new(pose.x as f32, pose.y as f32, pose.yaw as f32)
}

pub fn core_scan(step: &ScanStep) -> core::LaserScan<'_> {
    core::LaserScan {
        angle_min: step.scan.angle_min,
        angle_increment: step.scan.angle_increment,
        range_min: step.scan.range_min,
        range_max: step.scan.range_max,
        ranges: &step.scan.ranges,
    }
}
