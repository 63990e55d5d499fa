//! `map`: maps of nav2's map_server.

mod distances;
mod facts;
mod layers;
mod save;
mod source;

use std::path::PathBuf;

use anyhow::{Context, bail};
use clap::{Args, Subcommand, ValueEnum};
use horus_core::distance::{DistanceOptions, UnknownAs};
use horus_core::prelude::Pose2D;
use horus_host::lockstep::LockstepConfig;
use horus_host::map_server::MapFile;
use indicatif::ProgressBar;

use super::cost_options::CostOptions;
use super::out_dir::OutDir;
use super::progress;
use super::report;
use super::verdict::Verdict;
use distances::Distances;
use facts::MapFacts;

/// Turn a map_server file into costs and distances.
#[derive(Debug, Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct MapOptions {
    #[command(subcommand)]
    command: Option<MapCommand>,
    /// The map: YAML as nav2's map_server reads it, with a PGM or PNG image
    #[arg(required = true)]
    map: Option<PathBuf>,
    /// Directory for pictures and the log; without it the map is only read and counted
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Distances beyond this one are not told apart, in metres [default: any]
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    max_distance: Option<f32>,
    /// What unknown cells are to distances
    #[arg(long, value_enum, default_value_t = Unknown::Clear)]
    unknown: Unknown,
    /// Print one JSON object and nothing else
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    costs: CostOptions,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum Unknown {
    /// No obstacles
    Clear,
    /// Obstacles
    Obstacle,
}

#[derive(Debug, Subcommand)]
enum MapCommand {
    /// Save a map, or the last one of a log, as a map_server file
    Save(save::SaveOptions),
}

pub fn run(options: &MapOptions) -> anyhow::Result<Verdict> {
    if let Some(MapCommand::Save(options)) = &options.command {
        return save::run(options);
    }
    let path = options.map.as_deref().context("no map was given")?;
    options.costs.params().validate()?;
    let distances = options.distances()?;
    let bar = progress::rows(0);
    let map = load(path, &bar)?;
    let config = LockstepConfig {
        width: map.width,
        height: map.height,
        resolution: map.yaml.resolution as f32,
        params: options.costs.params(),
        ..LockstepConfig::default()
    };
    let mut facts = MapFacts::new(path, &map);
    if let Some(out) = &options.out {
        let out = OutDir::create(out)?;
        let image = path.with_file_name("").join(&map.yaml.image);
        out.keep(&image, &layers::FILES)?;
        let origin = pose(map.yaml.origin);
        facts.files = layers::write(&out, &config, origin, map, distances, &bar)?;
    }
    bar.finish_and_clear();
    report::print(&facts, &facts, options.json)?;
    Ok(Verdict::Whole)
}

impl MapOptions {
    fn distances(&self) -> anyhow::Result<Distances> {
        if let Some(metres) = self.max_distance
            && !(metres > 0.0 && metres.is_finite())
        {
            bail!("the longest distance must be a length above zero, not {metres}");
        }
        Ok(Distances {
            longest: self.max_distance,
            options: DistanceOptions {
                max_squared: None,
                unknown: match self.unknown {
                    Unknown::Clear => UnknownAs::Clear,
                    Unknown::Obstacle => UnknownAs::Obstacle,
                },
            },
        })
    }
}

/// Reads a map while the bar shows its rows.
fn load(path: &std::path::Path, bar: &ProgressBar) -> anyhow::Result<MapFile> {
    bar.set_message("reading");
    Ok(MapFile::load(path, &mut |row, rows| {
        if row % 64 == 0 || row == rows {
            bar.set_length(rows.into());
            bar.set_position(row.into());
        }
    })?)
}

/// The one rounding of the origin: the maps compute in f32.
fn pose([x, y, yaw]: [f64; 3]) -> Pose2D {
    Pose2D::new(x as f32, y as f32, yaw as f32)
}
