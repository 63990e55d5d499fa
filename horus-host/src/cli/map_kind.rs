use std::fs;
use std::path::PathBuf;

use anyhow::{Context, anyhow, bail};
use clap::{Args, ValueEnum};
use horus_host::lockstep::{LocalMapping, LockstepConfig};
use horus_host::navground::LocalMapFile;

/// Which map the scans are drawn into.
#[derive(Debug, Args)]
pub struct MapKindOptions {
    /// The map that scans are drawn into: the occupancy grid, or navground's local map, which does not use --model
    #[arg(long, value_enum, default_value_t = MapKind::Grid)]
    map: MapKind,
    /// With --map local: its properties, a YAML file in navground's form
    #[arg(long, value_name = "FILE")]
    config: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum MapKind {
    Grid,
    Local,
}

impl MapKindOptions {
    /// Makes `config` that of the chosen map. A file's size and resolution go before the options.
    pub fn apply(&self, config: &mut LockstepConfig) -> anyhow::Result<()> {
        match (self.map, &self.config) {
            (MapKind::Grid, None) => {}
            (MapKind::Grid, Some(_)) => {
                bail!("--config holds a local map's properties: it needs --map local")
            }
            (MapKind::Local, None) => config.local = Some(LocalMapping::default()),
            (MapKind::Local, Some(path)) => {
                let name = path.display();
                let text = fs::read_to_string(path).with_context(|| format!("cannot read {name}"))?;
                let file = LocalMapFile::parse(&text).map_err(|error| anyhow!("{name}: {error}"))?;
                if file.external_lidars.len() > 1 {
                    bail!(
                        "{name}: {} lidars are named, but the scans of a replay are those of one",
                        file.external_lidars.len()
                    );
                }
                (config.width, config.height, config.resolution) = (file.width, file.height, file.resolution);
                config.local = Some(LocalMapping {
                    footprint: file.footprint,
                    radius: file.radius,
                });
            }
        }
        Ok(())
    }
}
