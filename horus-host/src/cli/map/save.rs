use std::fmt;
use std::path::{Path, PathBuf};

use anyhow::bail;
use clap::Args;
use horus_host::map_server::{ImageFormat, MapMode, MapYaml, save};
use serde::Serialize;

use super::source::SourceMap;
use crate::cli::report;
use crate::cli::verdict::Verdict;

/// Save a map as a map_server file.
#[derive(Debug, Args)]
pub struct SaveOptions {
    /// The map: a map_server YAML file, or a log (MCAP)
    source: PathBuf,
    /// The YAML file to write; the image gets the same name
    yaml: PathBuf,
    /// Topic of the log; its last map is saved
    #[arg(long, value_name = "TOPIC", default_value = "/map")]
    topic: String,
    /// Kind of the image
    #[arg(long, value_enum, default_value_t = ImageFormat::Pgm)]
    format: ImageFormat,
    /// How values become shades
    #[arg(long, value_enum, default_value_t = MapMode::Trinary)]
    mode: MapMode,
    /// Print one JSON object and nothing else
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Serialize)]
struct Saved {
    width: u32,
    height: u32,
    resolution: f64,
    origin: [f64; 3],
    files: [PathBuf; 2],
}

pub fn run(options: &SaveOptions) -> anyhow::Result<Verdict> {
    let (source, yaml) = (&options.source, &options.yaml);
    let image = yaml.with_extension(match options.format {
        ImageFormat::Pgm => "pgm",
        ImageFormat::Png => "png",
    });
    if yaml.file_name().is_none() || image == *yaml {
        bail!("{} cannot be the name of the YAML file", yaml.display());
    }
    let map = SourceMap::read(source, &options.topic)?;
    for (written, read) in [yaml, &image]
        .into_iter()
        .flat_map(|w| map.files.iter().map(move |r| (w, r)))
    {
        if is_same(read, written) {
            bail!("{}: the map would be overwritten by itself", read.display());
        }
    }
    let text = MapYaml::new(map.resolution, map.origin, options.mode);
    save(yaml, &text, map.size, &map.cells, options.format)?;
    let saved = Saved {
        width: map.size.0,
        height: map.size.1,
        resolution: map.resolution,
        origin: map.origin,
        files: [yaml.clone(), image],
    };
    report::print(&saved, &saved, options.json)?;
    Ok(Verdict::Whole)
}

fn is_same(a: &Path, b: &Path) -> bool {
    a.canonicalize()
        .is_ok_and(|a| b.canonicalize().is_ok_and(|b| a == b))
}

impl fmt::Display for Saved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "size            {} x {} cells of {} m",
            self.width, self.height, self.resolution
        )?;
        for file in &self.files {
            writeln!(f, "wrote           {}", file.display())?;
        }
        Ok(())
    }
}
