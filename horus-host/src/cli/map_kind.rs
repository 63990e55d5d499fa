use clap::{Args, ValueEnum};
use horus_core::evidence::{FusionOperator, FusionRule};
use horus_host::lockstep::LockstepConfig;
use horus_host::lockstep::evidence::EvidenceConfig;

/// Which map the scans go into.
#[derive(Debug, Args)]
pub struct MapKindOptions {
    /// The map that scans go into: the occupancy grid with its cost map, or evidence grids, which take size and
    /// resolution of the options below and nothing else
    #[arg(long, value_enum, default_value_t = MapKind::Grid)]
    map: MapKind,
    /// With --map evidence: how scans are fused
    #[arg(long, value_name = "RULE", value_parser = fusion, default_value = "pcr6")]
    fusion: FusionOperator,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum MapKind {
    Grid,
    Evidence,
}

fn fusion(name: &str) -> Result<FusionOperator, String> {
    name.parse().map_err(|error: horus_core::Error| error.to_string())
}

impl MapKindOptions {
    /// The configuration of evidence grids, if they are what is asked for, of the same size as the grid's.
    pub fn evidence(&self, grid: &LockstepConfig) -> Option<EvidenceConfig> {
        (self.map == MapKind::Evidence).then(|| EvidenceConfig {
            width: grid.width,
            height: grid.height,
            resolution: grid.resolution,
            rule: FusionRule::new(self.fusion),
            ..EvidenceConfig::default()
        })
    }
}
