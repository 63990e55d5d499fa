//! `render`: grids of a log as PNG frames.

mod frame;
mod overlay;
mod select;

use std::path::PathBuf;

use anyhow::{Context, bail};
use clap::Args;
use horus_host::log::{LogEntry, LogReader};
use horus_host::picture::Picture;
use serde::Serialize;

use super::grid_picture::{GridPicture, is_grid};
use super::out_dir::OutDir;
use super::progress;
use super::report;
use super::survey::{Survey, in_file};
use super::verdict::Verdict;
use frame::{FrameOptions, paint};
use overlay::Overlay;
use select::{Partner, Selection, lethal_cost};

/// Paint the grids of a log.
#[derive(Debug, Args)]
pub struct RenderOptions {
    /// The log (MCAP)
    log: PathBuf,
    /// Directory for the frames
    #[arg(long, value_name = "DIR", default_value = "frames")]
    out: PathBuf,
    /// Topic of the grids [default: the first of /costmap, /local_map, /map, else any with grids]
    #[arg(long, value_name = "TOPIC")]
    topic: Option<String>,
    /// Paint every N-th message
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..))]
    every: u64,
    /// Paint one frame only: the last message at this time, in seconds after the first
    #[arg(
        long,
        value_name = "S",
        conflicts_with = "every",
        allow_negative_numbers = true
    )]
    at: Option<f64>,
    /// Another log: paint its grid of the same time beside, and where the two differ
    #[arg(long, value_name = "LOG")]
    against: Option<PathBuf>,
    /// Pixels per cell [default: as many as make 800 pixels]
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(1..=64))]
    scale: Option<u32>,
    /// Leave out scan and robot
    #[arg(long)]
    no_overlay: bool,
    /// Frame of the robot
    #[arg(long, value_name = "FRAME", default_value = "base_link")]
    base_frame: String,
    /// Topic of the scans to draw
    #[arg(long, value_name = "TOPIC", default_value = "/scan")]
    scan: String,
    /// Print one JSON object and nothing else
    #[arg(long)]
    json: bool,
}

/// What was painted.
#[derive(Debug, Serialize)]
struct Rendered {
    log: PathBuf,
    topic: String,
    messages: u64,
    frames: u64,
    files: Vec<PathBuf>,
}

pub fn run(options: &RenderOptions) -> anyhow::Result<Verdict> {
    let log = &options.log;
    let selection = Selection::of(log, options.topic.as_deref())?;
    let wanted = match options.at {
        None => None,
        Some(seconds) if seconds >= 0.0 => {
            Some(selection.first_ns.saturating_add((seconds * 1e9) as u64)) // saturates
        }
        Some(seconds) => bail!("a time in the log is zero or more seconds, not {seconds}"),
    };
    let out = OutDir::create(&options.out)?;
    let survey = Survey::of(log, None)?;
    let mut overlay =
        (!options.no_overlay).then(|| Overlay::new(&survey.tf, &options.scan, &options.base_frame));
    let mut partner = options
        .against
        .as_deref()
        .map(|path| Partner::open(path, &selection.topic))
        .transpose()?;
    let frame = FrameOptions {
        scale: options.scale,
        lethal_cost: lethal_cost(log)?,
    };
    let mut rendered = Rendered {
        log: log.clone(),
        topic: selection.topic.clone(),
        messages: 0,
        frames: 0,
        files: Vec::new(),
    };
    let bar = progress::bar(selection.messages);
    let stem = selection.topic.trim_matches('/').replace('/', "_");
    // The one frame of `--at`, until a later message of that time comes.
    let mut latest = None;
    for entry in LogReader::open(log).map_err(|error| in_file(log, error))? {
        let LogEntry::Message(message) = entry.map_err(|error| in_file(log, error))? else {
            continue;
        };
        if let Some(overlay) = &mut overlay {
            overlay.note(&message)?;
        }
        if message.topic() != selection.topic {
            continue;
        }
        bar.inc(1);
        rendered.messages += 1;
        let is_due = match wanted {
            Some(until_ns) => message.log_time_ns <= until_ns,
            None => (rendered.messages - 1).is_multiple_of(options.every),
        };
        if !is_due {
            continue;
        }
        let grid = GridPicture::of(&message, frame.lethal_cost).with_context(|| log.display().to_string())?;
        let other = match &mut partner {
            Some(partner) => partner.at(message.log_time_ns, frame.lethal_cost)?,
            None => None,
        };
        let picture = paint(
            &grid,
            partner.is_some().then_some(other.as_ref()),
            overlay.as_ref(),
            &frame,
        )?;
        let name = format!("{stem}_{:06}.png", rendered.messages - 1);
        if wanted.is_some() {
            latest = Some((name, picture, grid.transparent));
        } else {
            rendered
                .files
                .push(save(&out, &name, &picture, grid.transparent)?);
        }
    }
    bar.finish_and_clear();
    if let Some((name, picture, transparent)) = latest {
        rendered.files.push(save(&out, &name, &picture, transparent)?);
    }
    rendered.frames = rendered.files.len() as u64;
    let text = format!(
        "{}: {} of {} messages on {} painted into {}",
        log.display(),
        rendered.frames,
        rendered.messages,
        rendered.topic,
        options.out.display()
    );
    report::print(&rendered, text, options.json)?;
    Ok(Verdict::Whole)
}

fn save(
    out: &OutDir,
    name: &str,
    picture: &Picture,
    transparent: Option<horus_host::picture::Rgb>,
) -> anyhow::Result<PathBuf> {
    out.replace(name, |path| {
        match transparent {
            Some(colour) => picture.save_with_transparent(path, colour)?,
            None => picture.save(path)?,
        }
        Ok(())
    })
}
