use std::fmt;
use std::fs::{self, OpenOptions};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::Ordering;

use anyhow::{Context, bail};
use clap::Args;
use horus_host::frames::{ProblemKind, Problems, StreamReader, StreamSession, StreamedTick};
use horus_host::log::msg::{Header, LaserScan};
use horus_host::tf::Pose2;
use serde::Serialize;

use super::byte_source::ByteSource;
use super::map_geometry::MapGeometry;
use super::map_log::{Frames, MapLog};
use super::progress;
use super::report;
use super::step::ScanStep;
use super::summary::metadata;
use super::verdict::Verdict;

/// Record the frames of a target as a log.
#[derive(Debug, Args)]
pub struct RecordOptions {
    /// The stream: a serial device, a file, or - for standard input
    stream: PathBuf,
    /// The log to write (MCAP)
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// Speed of a serial device (8 data bits, no parity, 1 stop bit)
    #[arg(long, value_name = "BAUD", default_value_t = 115_200, value_parser = clap::value_parser!(u32).range(1..))]
    baud: u32,
    /// Stop after N ticks
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    limit: Option<u64>,
    /// Print one JSON object and nothing else
    #[arg(long)]
    json: bool,
}

/// What was recorded.
#[derive(Debug, Serialize)]
struct Recorded {
    source: String,
    bytes: u64,
    frames: u64,
    ticks: u64,
    /// Ticks of which something came, but not all, or that stood before the first whole map.
    skipped_ticks: u64,
    /// Text, and what is left of damaged frames.
    bytes_outside_frames: u64,
    problems: Problems,
    /// Why the source could not be read to its end.
    source_error: Option<String>,
    files: Vec<PathBuf>,
    #[serde(skip)]
    is_serial: bool,
}

pub fn run(options: &RecordOptions) -> anyhow::Result<Verdict> {
    let (stream, out) = (&options.stream, &options.out);
    let source = ByteSource::open(stream, options.baud)?;
    let is_new = check_output(stream, out)?;
    let recorded = record(options, source);
    if recorded.is_err() && is_new && fs::metadata(out).is_ok_and(|file| file.len() == 0) {
        let _ = fs::remove_file(out); // the error is the one to tell
    }
    let recorded = recorded?;
    report::print(&recorded, &recorded, options.json)?;
    Ok(recorded.verdict())
}

fn record(options: &RecordOptions, source: ByteSource) -> anyhow::Result<Recorded> {
    let (stop, is_serial) = (source.stop_flag(), source.is_serial());
    let mut reader = StreamReader::new(source);
    let mut log: Option<(MapLog, Arc<StreamSession>)> = None;
    let mut ticks = 0;
    let mut source_error = None;
    let bar = progress::ticks();
    while options.limit.is_none_or(|limit| ticks < limit) {
        let tick = match reader.next_tick() {
            Ok(Some(tick)) => tick,
            Ok(None) => break,
            Err(_) if stop.load(Ordering::Relaxed) => break,
            Err(error) => {
                source_error = Some(error.to_string());
                break;
            }
        };
        let log = match &mut log {
            Some((log, session)) => {
                if !Arc::ptr_eq(session, &tick.session) {
                    let (map, frames) = of_session(&tick.session);
                    log.change_map(map, &frames, target_metadata(&tick.session))?;
                    *session = Arc::clone(&tick.session);
                }
                log
            }
            none => {
                let (map, frames) = of_session(&tick.session);
                let created = MapLog::create(&options.out, map, &frames, target_metadata(&tick.session))?;
                &mut none.insert((created, Arc::clone(&tick.session))).0
            }
        };
        let maps = tick.maps.clone();
        log.write(&step(tick), maps.as_ref())?;
        ticks += 1;
        bar.set_position(ticks);
        if !reader.problems().is_empty() {
            bar.set_message(format!("{} skipped", reader.skipped_ticks()));
        }
    }
    bar.finish_and_clear();
    let name = options.stream.display();
    let Some((log, _)) = log else {
        let problems = reader.problems().to_string().replace('\n', "; ");
        let mut reasons = vec![problems];
        reasons.extend(source_error);
        reasons.retain(|reason| !reason.is_empty());
        let reasons = reasons.join("; ");
        let why = if reasons.is_empty() {
            String::new()
        } else {
            format!(": {reasons}")
        };
        bail!(
            "{name}: no whole tick in {} bytes and {} frames{why}",
            reader.bytes(),
            reader.frames()
        );
    };
    Ok(Recorded {
        source: name.to_string(),
        bytes: reader.bytes(),
        frames: reader.frames(),
        ticks,
        skipped_ticks: reader.skipped_ticks(),
        bytes_outside_frames: reader.bytes_outside(),
        problems: reader.problems().clone(),
        source_error,
        files: vec![log.finish()?],
        is_serial,
    })
}

/// Checks that the log can be written and is not its own source; whether it is a new file.
fn check_output(stream: &Path, out: &Path) -> anyhow::Result<bool> {
    let same = |a: &Path, b: &Path| {
        a.canonicalize()
            .is_ok_and(|a| b.canonicalize().is_ok_and(|b| a == b))
    };
    if same(stream, out) {
        bail!(
            "{}: the stream would be overwritten by its own log",
            stream.display()
        );
    }
    let is_new = !out.exists();
    let opened = OpenOptions::new().append(true).create(true).open(out);
    opened.with_context(|| format!("cannot write the log {}", out.display()))?;
    Ok(is_new)
}

fn of_session(session: &StreamSession) -> (MapGeometry, Frames) {
    let frames = Frames {
        odom: session.odom.clone(),
        base: session.base.clone(),
    };
    (MapGeometry::with_origin(&session.config, session.origin), frames)
}

fn target_metadata(session: &StreamSession) -> std::collections::BTreeMap<String, String> {
    metadata(&session.config, &session.odom, "target")
}

/// The tick as a step of a run on the host.
fn step(tick: StreamedTick) -> ScanStep {
    let last_beam = tick.ranges.len().saturating_sub(1) as f32;
    ScanStep {
        stamp_ns: tick.stamp_ns,
        scan: LaserScan {
            header: Header::new(tick.stamp_ns, &tick.session.sensor),
            angle_min: tick.angle_min,
            angle_max: tick.angle_min + last_beam * tick.angle_increment,
            angle_increment: tick.angle_increment,
            time_increment: 0.0,
            scan_time: 0.0,
            range_min: tick.range_min,
            range_max: tick.range_max,
            ranges: tick.ranges,
            intensities: Vec::new(),
        },
        robot: exact(tick.robot),
        sensor: exact(tick.sensor),
        mount: exact(tick.session.mount),
        map_from_odom: None,
    }
}

fn exact(pose: horus_core::prelude::Pose2D) -> Pose2 {
    Pose2 {
        x: pose.x.into(),
        y: pose.y.into(),
        yaw: pose.theta.into(),
    }
}

impl Recorded {
    fn verdict(&self) -> Verdict {
        // A device is usually opened while the target is already sending.
        let is_expected = |kind| self.is_serial && kind == ProblemKind::JoinedLate;
        let is_whole = self.source_error.is_none() && self.problems.iter().all(|(kind, _)| is_expected(kind));
        if is_whole { Verdict::Whole } else { Verdict::Lossy }
    }
}

impl fmt::Display for Recorded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "source          {}", self.source)?;
        writeln!(
            f,
            "bytes           {}, {} outside of frames",
            self.bytes, self.bytes_outside_frames
        )?;
        writeln!(f, "frames          {}", self.frames)?;
        writeln!(f, "ticks           {}", self.ticks)?;
        if self.skipped_ticks > 0 {
            writeln!(f, "skipped         {} ticks", self.skipped_ticks)?;
        }
        for line in self.problems.to_string().lines() {
            writeln!(f, "problem         {line}")?;
        }
        if let Some(error) = &self.source_error {
            writeln!(
                f,
                "problem         the stream could not be read to its end: {error}"
            )?;
        }
        for file in &self.files {
            writeln!(f, "wrote           {}", file.display())?;
        }
        Ok(())
    }
}
