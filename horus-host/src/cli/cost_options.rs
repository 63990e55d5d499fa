use clap::{Args, ValueEnum};
use horus_core::prelude::{CostParams, Decay};

/// Parameters of the costs, for every command that computes them.
#[derive(Debug, Args)]
#[command(next_help_heading = "Costs")]
pub struct CostOptions {
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

impl CostOptions {
    /// The parameters these options ask for; not yet validated.
    pub fn params(&self) -> CostParams {
        let preset = match self.preset {
            Preset::Default => CostParams::default(),
            Preset::Horus => CostParams::horus(),
            Preset::Nav2 => CostParams::nav2(),
        };
        CostParams {
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
        }
    }
}
