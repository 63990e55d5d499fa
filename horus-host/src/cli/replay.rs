use std::path::PathBuf;

use anyhow::{Context, anyhow, bail};
use clap::Args;
use horus_host::log::{LogReader, ReadEnd};

use super::evidence::EvidenceSession;
use super::map_kind::MapKindOptions;
use super::map_log::Frames;
use super::map_options::MapOptions;
use super::out_dir::OutDir;
use super::progress;
use super::recording::Recording;
use super::session::{LOG_NAMES, Session, conclude};
use super::skipped::Skipped;
use super::survey::{Survey, in_file};
use super::verdict::Verdict;

/// Replay the laser scans of a recorded log.
#[derive(Debug, Args)]
pub struct ReplayOptions {
    /// The log: MCAP with profile ros2, its scans, /tf and /tf_static
    log: PathBuf,
    /// Directory for logs, pictures and summary; without it nothing is written
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Topic of the scans [default: the only one with scans, else /scan]
    #[arg(long, value_name = "TOPIC")]
    scan: Option<String>,
    /// Frame the map lies in
    #[arg(long, value_name = "FRAME", default_value = "odom")]
    odom_frame: String,
    /// Frame of the robot
    #[arg(long, value_name = "FRAME", default_value = "base_link")]
    base_frame: String,
    /// Longest gap between two transforms that poses are interpolated across [default: any]
    #[arg(long, value_name = "S", allow_negative_numbers = true)]
    max_gap: Option<f64>,
    /// Use every K-th scan only
    #[arg(long, value_name = "K", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..))]
    every: u64,
    /// Stop after N scans
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    limit: Option<u64>,
    /// Log the maps of every K-th used scan only
    #[arg(long, value_name = "K", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..))]
    log_every: u64,
    /// Print one JSON object and nothing else
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    kind: MapKindOptions,
    #[command(flatten)]
    map: MapOptions,
}

pub fn run(options: &ReplayOptions) -> anyhow::Result<Verdict> {
    let mut config = options.map.config();
    options.kind.apply(&mut config)?;
    config.validate()?;
    let evidence = options.kind.evidence(&config);
    let longest_gap_ns = match options.max_gap {
        None => None,
        Some(seconds) if seconds >= 0.0 => Some((seconds * 1e9) as u64), // saturates
        Some(seconds) => bail!("the longest gap must be zero or more seconds, not {seconds}"),
    };
    let log = &options.log;
    let name = log.display();
    // Whatever can be refused at once is refused before the log is read.
    LogReader::open(log).map_err(|error| in_file(log, error))?;
    let out = options.out.as_deref().map(OutDir::create).transpose()?;
    if let Some(out) = &out {
        out.keep(log, &LOG_NAMES)?;
    }

    let survey = Survey::of(log, longest_gap_ns)?;
    let topic = survey
        .scan_topic(options.scan.as_deref())
        .with_context(|| name.to_string())?;
    let without_slash = |frame: &str| frame.trim_start_matches('/').to_owned();
    let frames = Frames {
        odom: without_slash(&options.odom_frame),
        base: without_slash(&options.base_frame),
    };
    let steps = Recording::open(log, &topic.name, &survey.tf, &frames, options.every)?;
    let (beams, limit) = (topic.beams, options.limit.unwrap_or(u64::MAX));
    let scans = topic.scans.div_ceil(options.every);
    let bar = progress::bar(scans.min(limit));
    let source = format!("{name} {}", topic.name);
    let none_used = |skipped_scans: u64, skipped: &Skipped| {
        let rejected = survey.first_rejection.as_ref().map_or_else(String::new, |first| {
            format!(
                "; {} transforms were rejected ({first})",
                survey.rejected_transforms
            )
        });
        anyhow!(
            "{name}: none of the {skipped_scans} scans on {} can be used: {skipped}{rejected}",
            topic.name
        )
    };
    let truncated_at_byte = match survey.end {
        ReadEnd::Complete => None,
        ReadEnd::Truncated { offset } => Some(offset),
    };
    if let Some(config) = evidence {
        let session = EvidenceSession {
            config,
            frames: &frames,
            beams,
            out: out.as_ref(),
            log_every: options.log_every,
            limit,
        };
        let mut summary = session.run(source, steps, &bar)?;
        if summary.scans == 0 {
            return Err(none_used(summary.skipped_scans, &summary.skipped));
        }
        summary.rejected_transforms = survey.rejected_transforms;
        summary.truncated_at_byte = truncated_at_byte;
        return conclude(summary, out.as_ref(), options.json);
    }
    let session = Session {
        config,
        frames: &frames,
        beams,
        out: out.as_ref(),
        log_every: options.log_every,
        limit,
    };
    let mut summary = session.run(source, steps, &bar)?;
    if summary.scans == 0 {
        return Err(none_used(summary.skipped_scans, &summary.skipped));
    }
    summary.rejected_transforms = survey.rejected_transforms;
    summary.truncated_at_byte = truncated_at_byte;
    conclude(summary, out.as_ref(), options.json)
}
