use std::collections::BTreeMap;
use std::fmt;
use std::path::PathBuf;

use horus_host::lockstep::evidence::{EvidenceConfig, EvidenceTotals};
use serde::Serialize;

use crate::cli::session::Told;
use crate::cli::skipped::Skipped;

/// What a run found: `summary.json`, the output of `--json`, and as text the table for people.
#[derive(Debug, Serialize)]
pub struct EvidenceSummary {
    /// The log and topic.
    pub source: String,
    pub fusion: &'static str,
    pub scans: u64,
    pub cells_compared: u64,
    pub mismatches: u64,
    /// Of a mass between core and std version, over the whole run, and what is allowed.
    pub largest_difference: f64,
    pub bound: f64,
    pub conflicts: u64,
    pub core_us_per_scan: f64,
    pub std_us_per_scan: f64,
    pub ram_bytes: usize,
    pub width: u32,
    pub height: u32,
    pub resolution: f32,
    pub skipped_scans: u64,
    pub skipped: Skipped,
    pub rejected_transforms: u64,
    /// Where a log that ends in the middle was left.
    pub truncated_at_byte: Option<u64>,
    pub first_mismatch: Option<String>,
    pub files: Vec<PathBuf>,
}

impl EvidenceSummary {
    /// The summary of a run; what only the source knows is left empty.
    pub fn new(source: String, config: &EvidenceConfig, ram_bytes: usize, totals: &EvidenceTotals) -> Self {
        let per_scan = |time: std::time::Duration| time.as_secs_f64() * 1e6 / totals.ticks.max(1) as f64;
        Self {
            source,
            fusion: config.rule.operator.as_str(),
            scans: totals.ticks,
            cells_compared: totals.cells_compared,
            mismatches: totals.mismatches,
            largest_difference: totals.largest_difference,
            bound: config.bound(),
            conflicts: totals.conflicts,
            core_us_per_scan: per_scan(totals.core_time),
            std_us_per_scan: per_scan(totals.std_time),
            ram_bytes,
            width: config.width,
            height: config.height,
            resolution: config.resolution,
            skipped_scans: 0,
            skipped: Skipped::default(),
            rejected_transforms: 0,
            truncated_at_byte: None,
            first_mismatch: totals.first_mismatch.clone(),
            files: Vec::new(),
        }
    }
}

impl Told for EvidenceSummary {
    fn mismatches(&self) -> u64 {
        self.mismatches
    }

    fn files(&mut self) -> &mut Vec<PathBuf> {
        &mut self.files
    }
}

/// The values of the `horus` metadata record of a log written by `side`.
pub fn metadata(config: &EvidenceConfig, frame: &str, side: &str) -> BTreeMap<String, String> {
    let values: [(&str, &dyn fmt::Display); 16] = [
        ("version", &env!("CARGO_PKG_VERSION")),
        ("side", &side),
        ("frame_id", &frame),
        ("map", &"evidence"),
        ("width", &config.width),
        ("height", &config.height),
        ("resolution", &config.resolution),
        ("fusion", &config.rule.operator),
        ("ignorance_floor", &config.rule.ignorance_floor),
        ("m_free", &config.model.m_free.free()),
        ("m_occ", &config.model.m_occ.occupied()),
        ("wall_thickness", &config.model.wall_thickness),
        ("free_threshold", &config.thresholds.free_threshold),
        ("is_optimistic", &config.thresholds.is_optimistic),
        ("occupied_threshold", &config.thresholds.occupied_threshold),
        ("max_distance", &config.max_distance),
    ];
    let pair = |(key, value): (&str, &dyn fmt::Display)| (key.to_owned(), value.to_string());
    values.into_iter().map(pair).collect()
}

impl fmt::Display for EvidenceSummary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "source          {}", self.source)?;
        writeln!(
            f,
            "map             evidence, {} x {} cells of {} m, {}",
            self.width, self.height, self.resolution, self.fusion
        )?;
        writeln!(f, "scans           {}", self.scans)?;
        if self.skipped_scans > 0 {
            writeln!(f, "skipped         {}", self.skipped)?;
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
            "masses          differ by at most {:.2e}, {:.0e} is allowed",
            self.largest_difference, self.bound
        )?;
        writeln!(f, "conflicts       {} cells", self.conflicts)?;
        writeln!(
            f,
            "time per scan   core {:.1} us, std {:.1} us",
            self.core_us_per_scan, self.std_us_per_scan
        )?;
        writeln!(f, "core RAM        {} bytes", self.ram_bytes)?;
        for file in &self.files {
            writeln!(f, "wrote           {}", file.display())?;
        }
        if let Some(mismatch) = &self.first_mismatch {
            writeln!(f, "first mismatch: {mismatch}")?;
        }
        Ok(())
    }
}
