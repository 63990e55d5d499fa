use std::collections::BTreeMap;
use std::fmt;
use std::path::PathBuf;

use horus_core::prelude::{CostParams, Decay, ScanModel};
use horus_host::lockstep::{CoreStorage, LockstepConfig, Mismatch, Totals};
use serde::Serialize;

use super::skipped::Skipped;

/// What a run found: `summary.json`, the output of `--json`, and as text the table for people.
#[derive(Debug, Serialize)]
pub struct Summary {
    /// The log, or the simulation with its seed.
    pub source: String,
    pub scans: u64,
    pub cells_compared: u64,
    pub mismatches: u64,
    pub core_us_per_scan: f64,
    pub std_us_per_scan: f64,
    pub ram_bytes: usize,
    pub ram_bytes_per_cell: f64,
    pub width: u32,
    pub height: u32,
    pub resolution: f32,
    pub model: &'static str,
    pub parameters: Parameters,
    pub effective_radius_cells: u32,
    /// The core's distance field: `u8` or `u16`.
    pub field: &'static str,
    pub kept_costs: bool,
    pub skipped_scans: u64,
    pub skipped: Skipped,
    /// Scans older than the one before them.
    pub out_of_order_scans: u64,
    pub rejected_transforms: u64,
    /// Where a log that ends in the middle was left.
    pub truncated_at_byte: Option<u64>,
    pub first_mismatch: Option<FirstMismatch>,
    pub files: Vec<PathBuf>,
}

/// Parameters of the cost map, by the names of the core's fields.
#[derive(Debug, Serialize)]
pub struct Parameters {
    inflation_radius: f32,
    cost_scaling_factor: f32,
    lethal_cost: u8,
    lethal_threshold: i8,
    unknown_inflates: bool,
    decay: &'static str,
    inscribed_radius: f32,
    inflate_unknown: bool,
}

/// The first mismatch, field by field.
#[derive(Debug, Serialize)]
pub struct FirstMismatch {
    layer: &'static str,
    tick: u64,
    stamp_ns: u64,
    cell: Option<(u32, u32)>,
    core: String,
    std: String,
    picture: String,
    #[serde(skip)]
    text: String,
}

impl Summary {
    /// The summary of a run; what only the source knows is left empty.
    pub fn new(source: String, config: &LockstepConfig, storage: &Storage, totals: &Totals) -> Self {
        Self {
            source,
            scans: totals.ticks,
            cells_compared: totals.cells_compared,
            mismatches: totals.mismatches,
            core_us_per_scan: totals.core_us_per_tick(),
            std_us_per_scan: totals.std_us_per_tick(),
            ram_bytes: storage.ram_bytes,
            ram_bytes_per_cell: storage.ram_bytes_per_cell,
            width: config.width,
            height: config.height,
            resolution: config.resolution,
            model: model_name(config),
            parameters: Parameters::from(&config.params),
            effective_radius_cells: storage.effective_radius,
            field: storage.field,
            kept_costs: config.keep_costs,
            skipped_scans: 0,
            skipped: Skipped::default(),
            out_of_order_scans: 0,
            rejected_transforms: 0,
            truncated_at_byte: None,
            first_mismatch: None,
            files: Vec::new(),
        }
    }
}

/// Facts about the core's memory, taken before it is borrowed.
#[derive(Debug, Clone, Copy)]
pub struct Storage {
    ram_bytes: usize,
    ram_bytes_per_cell: f64,
    effective_radius: u32,
    field: &'static str,
}

impl From<&CoreStorage> for Storage {
    fn from(storage: &CoreStorage) -> Self {
        let ram = storage.ram_use();
        Self {
            ram_bytes: ram.total(),
            ram_bytes_per_cell: ram.per_cell(),
            effective_radius: storage.effective_radius(),
            field: storage.field_width().name(),
        }
    }
}

impl From<&CostParams> for Parameters {
    fn from(params: &CostParams) -> Self {
        Self {
            inflation_radius: params.inflation_radius,
            cost_scaling_factor: params.cost_scaling_factor,
            lethal_cost: params.lethal_cost,
            lethal_threshold: params.lethal_threshold,
            unknown_inflates: params.unknown_inflates,
            decay: match params.decay {
                Decay::Polynomial => "polynomial",
                Decay::Exponential => "exponential",
            },
            inscribed_radius: params.inscribed_radius,
            inflate_unknown: params.inflate_unknown,
        }
    }
}

impl From<&Mismatch> for FirstMismatch {
    fn from(mismatch: &Mismatch) -> Self {
        Self {
            layer: mismatch.layer.name(),
            tick: mismatch.tick,
            stamp_ns: mismatch.stamp_ns,
            cell: mismatch.cell,
            core: mismatch.core.clone(),
            std: mismatch.std.clone(),
            picture: mismatch.picture.clone(),
            text: mismatch.to_string(),
        }
    }
}

/// The values of the `horus` metadata record of a log written by `side`.
pub fn metadata(config: &LockstepConfig, frame: &str, side: &str) -> BTreeMap<String, String> {
    let p = Parameters::from(&config.params);
    let values: [(&str, &dyn fmt::Display); 15] = [
        ("version", &env!("CARGO_PKG_VERSION")),
        ("side", &side),
        ("frame_id", &frame),
        ("width", &config.width),
        ("height", &config.height),
        ("resolution", &config.resolution),
        ("model", &model_name(config)),
        ("inflation_radius", &p.inflation_radius),
        ("cost_scaling_factor", &p.cost_scaling_factor),
        ("lethal_cost", &p.lethal_cost),
        ("lethal_threshold", &p.lethal_threshold),
        ("unknown_inflates", &p.unknown_inflates),
        ("decay", &p.decay),
        ("inscribed_radius", &p.inscribed_radius),
        ("inflate_unknown", &p.inflate_unknown),
    ];
    let pair = |(key, value): (&str, &dyn fmt::Display)| (key.to_owned(), value.to_string());
    let mut metadata: BTreeMap<_, _> = values.into_iter().map(pair).collect();
    if let Some(local) = config.local {
        metadata.extend([
            pair(("footprint", &local.footprint.as_str())),
            pair(("footprint_radius", &local.radius)),
        ]);
    }
    metadata
}

fn model_name(config: &LockstepConfig) -> &'static str {
    match config.model {
        _ if config.local.is_some() => "local",
        ScanModel::Set => "set",
        ScanModel::Accumulate { .. } => "accumulate",
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let p = &self.parameters;
        writeln!(f, "source          {}", self.source)?;
        writeln!(
            f,
            "map             {} x {} cells of {} m, model {}",
            self.width, self.height, self.resolution, self.model
        )?;
        writeln!(
            f,
            "costs           {}, radius {} m, scaling {}, reach {} cells",
            p.decay, p.inflation_radius, p.cost_scaling_factor, self.effective_radius_cells
        )?;
        writeln!(f, "scans           {}", self.scans)?;
        if self.skipped_scans > 0 {
            writeln!(f, "skipped         {}", self.skipped)?;
        }
        if self.out_of_order_scans > 0 {
            writeln!(f, "out of order    {} scans", self.out_of_order_scans)?;
        }
        if self.rejected_transforms > 0 {
            writeln!(f, "rejected        {} transforms", self.rejected_transforms)?;
        }
        if let Some(offset) = self.truncated_at_byte {
            writeln!(f, "truncated       the log was read up to byte {offset}")?;
        }
        writeln!(f, "cells compared  {}", self.cells_compared)?;
        writeln!(f, "mismatches      {}", self.mismatches)?;
        writeln!(
            f,
            "time per scan   core {:.1} us, std {:.1} us",
            self.core_us_per_scan, self.std_us_per_scan
        )?;
        writeln!(
            f,
            "core RAM        {} bytes, {:.3} per cell, field {}",
            self.ram_bytes, self.ram_bytes_per_cell, self.field
        )?;
        for file in &self.files {
            writeln!(f, "wrote           {}", file.display())?;
        }
        if let Some(mismatch) = &self.first_mismatch {
            writeln!(f, "{}", mismatch.text)?;
        }
        Ok(())
    }
}
