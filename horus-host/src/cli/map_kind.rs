use std::fs;
use std::path::PathBuf;

use anyhow::{Context, anyhow, bail};
use clap::{Args, ValueEnum};
use horus_core::evidence::{FusionOperator, FusionRule};
use horus_host::lockstep::evidence::EvidenceConfig;
use horus_host::lockstep::{LocalMapping, LockstepConfig};
use horus_host::navground::LocalMapFile;

/// Which map the scans go into.
#[derive(Debug, Args)]
pub struct MapKindOptions {
    /// The map that scans go into: the occupancy grid; navground's local map, which does not use --model; or evidence
    /// grids, which take size and resolution of the options below and nothing else
    #[arg(long, value_enum, default_value_t = MapKind::Grid)]
    map: MapKind,
    /// With --map local: its properties, a YAML file in navground's form
    #[arg(long, value_name = "FILE")]
    config: Option<PathBuf>,
    /// With --map evidence: how scans are fused [default: pcr6]
    #[arg(long, value_name = "RULE", value_parser = fusion)]
    fusion: Option<FusionOperator>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum MapKind {
    Grid,
    Local,
    Evidence,
}

fn fusion(name: &str) -> Result<FusionOperator, String> {
    name.parse().map_err(|error: horus_core::Error| error.to_string())
}

impl MapKindOptions {
    /// Makes `config` that of the chosen map. A file's size and resolution go before the options.
    pub fn apply(&self, config: &mut LockstepConfig) -> anyhow::Result<()> {
        if self.fusion.is_some() && self.map != MapKind::Evidence {
            bail!("--fusion is a rule of evidence grids: it needs --map evidence");
        }
        match (self.map, &self.config) {
            (MapKind::Grid | MapKind::Evidence, None) => {}
            (MapKind::Grid | MapKind::Evidence, Some(_)) => {
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

    /// The configuration of evidence grids, if they are what is asked for, of the same size as the grid's.
    pub fn evidence(&self, grid: &LockstepConfig) -> Option<EvidenceConfig> {
        (self.map == MapKind::Evidence).then(|| EvidenceConfig {
            width: grid.width,
            height: grid.height,
            resolution: grid.resolution,
            rule: FusionRule::new(self.fusion.unwrap_or_default()),
            ..EvidenceConfig::default()
        })
    }
}
