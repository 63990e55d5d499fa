//! Replay of scans into evidence grids.

mod log;
mod summary;

use std::path::PathBuf;

use horus_core::prelude as core;
use horus_host::lockstep::evidence::{EvidenceConfig, EvidenceLayers, EvidenceLockstep, EvidenceStorage};
use horus_host::picture::{Cells, Picture, palette};
use indicatif::ProgressBar;

use self::log::EvidenceLog;
pub use self::summary::EvidenceSummary;
use super::map_log::Frames;
use super::out_dir::OutDir;
use super::session::{LOG_NAMES, core_scan, rounded};
use super::skipped::Skipped;
use super::step::{ScanStep, SkipReason, Step};

/// A lockstep run of evidence grids over scans, and where its results go.
pub struct EvidenceSession<'a> {
    pub config: EvidenceConfig,
    pub frames: &'a Frames,
    /// Most beams of a scan.
    pub beams: usize,
    pub out: Option<&'a OutDir>,
    /// Every how many scans the maps are logged.
    pub log_every: u64,
    /// Most scans to use.
    pub limit: u64,
}

impl EvidenceSession<'_> {
    /// Runs all scans through both sides; writes logs and pictures, not the summary.
    pub fn run(
        &self,
        source: String,
        steps: impl Iterator<Item = anyhow::Result<Step>>,
        bar: &ProgressBar,
    ) -> anyhow::Result<EvidenceSummary> {
        let mut skipped = Skipped::default();
        let mut steps = steps.filter_map(|step| {
            bar.inc(1);
            match step {
                Ok(Step::Scan(step)) => Some(Ok(step)),
                Ok(Step::Skipped(reason)) => {
                    skipped.add(&reason);
                    None
                }
                Err(error) => Some(Err(error)),
            }
        });
        // The sensor stands where the first scan finds it on the robot.
        let first = steps.next().transpose()?;
        let mount = first
            .as_ref()
            .map_or_else(core::Pose2D::default, |step| rounded(step.mount));
        let mut storage = EvidenceStorage::new(&self.config, self.beams, mount)?;
        let ram_bytes = storage.bytes();
        let mut lockstep = EvidenceLockstep::new(&self.config, &mut storage)?;
        let mut logs: Option<[EvidenceLog; 2]> = None;
        let mut refused = Vec::new();
        for step in first.map(Ok).into_iter().chain(steps) {
            let step: Box<ScanStep> = step?;
            let here = rounded(step.mount);
            let refusal = if [here.x - mount.x, here.y - mount.y, here.theta - mount.theta]
                .iter()
                .all(|moved| moved.abs() <= 1e-4)
            {
                lockstep.tick(&core_scan(&step), rounded(step.robot))
            } else {
                Some("the sensor has moved on the robot".into())
            };
            if let Some(reason) = refusal {
                refused.push(SkipReason::Refused(reason));
                continue;
            }
            if let Some(out) = self.out {
                let logs = match &mut logs {
                    Some(logs) => logs,
                    none => none.insert(self.start_logs(out)?),
                };
                let due = (lockstep.totals().ticks - 1).is_multiple_of(self.log_every);
                let layers = due.then(|| [lockstep.core_layers(), lockstep.std_layers()]);
                for (i, log) in logs.iter_mut().enumerate() {
                    log.write(&step, layers.as_ref().map(|layers| &layers[i]))?;
                }
            }
            if lockstep.totals().ticks >= self.limit {
                break;
            }
        }
        bar.finish_and_clear();

        refused.iter().for_each(|reason| skipped.add(reason));
        let mut summary = EvidenceSummary::new(source, &self.config, ram_bytes, lockstep.totals());
        summary.skipped_scans = skipped.total();
        summary.skipped = skipped;
        for log in logs.into_iter().flatten() {
            summary.files.push(log.finish()?);
        }
        if let Some(out) = self.out
            && lockstep.totals().ticks > 0
        {
            summary.files.extend(self.paint(out, &lockstep.core_layers())?);
        }
        Ok(summary)
    }

    fn start_logs(&self, out: &OutDir) -> anyhow::Result<[EvidenceLog; 2]> {
        let [core, std] = LOG_NAMES;
        let start = |name: &str, side: &str| {
            let metadata = summary::metadata(&self.config, &self.frames.odom, side);
            EvidenceLog::create(&out.file(name), &self.config, self.frames, metadata)
        };
        Ok([start(core, "core")?, start(std, "std")?])
    }

    /// Paints core's maps after the last scan.
    fn paint(&self, out: &OutDir, layers: &EvidenceLayers) -> anyhow::Result<Vec<PathBuf>> {
        let EvidenceConfig {
            width,
            height,
            max_distance,
            ..
        } = self.config;
        let scale = (super::session::PICTURE_SIZE / width.max(height)).clamp(1, 16);
        let evidence = Picture::paint(
            Cells::new(width, height, &layers.masses)?,
            scale,
            palette::evidence,
        )?;
        let binary = Picture::paint(Cells::new(width, height, &layers.binary)?, scale, palette::binary)?;
        let distance = Picture::paint(Cells::new(width, height, &layers.distance)?, scale, |metres| {
            palette::distance(metres, max_distance)
        })?;
        [
            ("evidence.png", evidence),
            ("binary.png", binary),
            ("distance.png", distance),
        ]
        .into_iter()
        .map(|(name, picture)| out.replace(name, |path| Ok(picture.save(path)?)))
        .collect()
    }
}
