use clap::{Args, ValueEnum};
use horus_core::prelude::ScanModel;
use horus_host::lockstep::LockstepConfig;

use super::cost_options::CostOptions;

/// Size and parameters of the map, for every command that makes one.
#[derive(Debug, Args)]
#[command(next_help_heading = "Map")]
pub struct MapOptions {
    /// Columns
    #[arg(
        long,
        value_name = "CELLS",
        default_value_t = 200,
        allow_negative_numbers = true
    )]
    width: u32,
    /// Rows
    #[arg(
        long,
        value_name = "CELLS",
        default_value_t = 200,
        allow_negative_numbers = true
    )]
    height: u32,
    /// Metres per cell
    #[arg(long, value_name = "M", default_value_t = 0.05, allow_negative_numbers = true)]
    resolution: f32,
    /// How scans change cells: to 0 and 100, or by one step per scan
    #[arg(long, value_enum, default_value_t = Model::Set)]
    model: Model,
    /// Let the core keep its costs as bytes: one more per cell
    #[arg(long)]
    keep_costs: bool,
    #[command(flatten)]
    costs: CostOptions,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum Model {
    Set,
    Accumulate,
}

impl MapOptions {
    /// The map these options ask for; not yet validated.
    pub fn config(&self) -> LockstepConfig {
        LockstepConfig {
            width: self.width,
            height: self.height,
            resolution: self.resolution,
            params: self.costs.params(),
            model: match self.model {
                Model::Set => ScanModel::Set,
                Model::Accumulate => ScanModel::accumulate(),
            },
            keep_costs: self.keep_costs,
            local: None,
        }
    }
}
