use clap::{Args, ValueEnum};
use horus_core::prelude::{CostParams, Decay, ScanModel};
use horus_host::lockstep::LockstepConfig;

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
    /// Parameters to start from; the options below change single ones
    #[arg(long, value_enum, default_value_t = Preset::Default)]
    preset: Preset,
    /// Inflation radius in metres
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    radius: Option<f32>,
    /// How the cost falls with distance
    #[arg(long, value_enum)]
    decay: Option<DecayLaw>,
    /// Cost scaling factor: how fast the cost falls
    #[arg(long, value_name = "K", allow_negative_numbers = true)]
    scaling: Option<f32>,
    /// Inscribed radius in metres (exponential decay)
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    inscribed: Option<f32>,
    /// Cost of an obstacle, 2 to 254
    #[arg(long, value_name = "COST", allow_negative_numbers = true)]
    lethal_cost: Option<u8>,
    /// Lowest occupancy that is an obstacle, 1 to 100
    #[arg(long, value_name = "OCCUPANCY", allow_negative_numbers = true)]
    lethal_threshold: Option<i8>,
    /// Whether unknown cells are inflated like obstacles
    #[arg(long, value_name = "BOOL", num_args = 0..=1, default_missing_value = "true")]
    unknown_inflates: Option<bool>,
    /// Whether unknown cells take any inflated cost (exponential decay)
    #[arg(long, value_name = "BOOL", num_args = 0..=1, default_missing_value = "true")]
    inflate_unknown: Option<bool>,
    /// Let the core keep its costs as bytes: one more per cell
    #[arg(long)]
    keep_costs: bool,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum Model {
    Set,
    Accumulate,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum Preset {
    Default,
    Horus,
    Nav2,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum DecayLaw {
    Polynomial,
    Exponential,
}

impl MapOptions {
    /// The map these options ask for; not yet validated.
    pub fn config(&self) -> LockstepConfig {
        let preset = match self.preset {
            Preset::Default => CostParams::default(),
            Preset::Horus => CostParams::horus(),
            Preset::Nav2 => CostParams::nav2(),
        };
        LockstepConfig {
            width: self.width,
            height: self.height,
            resolution: self.resolution,
            params: CostParams {
                inflation_radius: self.radius.unwrap_or(preset.inflation_radius),
                cost_scaling_factor: self.scaling.unwrap_or(preset.cost_scaling_factor),
                lethal_cost: self.lethal_cost.unwrap_or(preset.lethal_cost),
                lethal_threshold: self.lethal_threshold.unwrap_or(preset.lethal_threshold),
                unknown_inflates: self.unknown_inflates.unwrap_or(preset.unknown_inflates),
                decay: match self.decay {
                    Some(DecayLaw::Polynomial) => Decay::Polynomial,
                    Some(DecayLaw::Exponential) => Decay::Exponential,
                    None => preset.decay,
                },
                inscribed_radius: self.inscribed.unwrap_or(preset.inscribed_radius),
                inflate_unknown: self.inflate_unknown.unwrap_or(preset.inflate_unknown),
            },
            model: match self.model {
                Model::Set => ScanModel::Set,
                Model::Accumulate => ScanModel::accumulate(),
            },
            keep_costs: self.keep_costs,
            local: None,
        }
    }
}
