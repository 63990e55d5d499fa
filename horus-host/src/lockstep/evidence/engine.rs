use std::time::{Duration, Instant};

use horus_core::distance::{DistanceBuffers, EnvelopeVertex};
use horus_core::evidence::{
    BeamLimits, EvidenceU16, Flatscan, LocalMapping, LocalMappingConfig, MappingBuffers, SensorConfig,
    SensorScan, class_bytes,
};
use horus_core::prelude::{LaserScan, Pose2D};
use horus_core::storage::bitmap_words;

use super::{EvidenceConfig, EvidenceLayers, distance};
use crate::lockstep::LockstepError;
use crate::reference::evidence as std_version;

/// Ticks between two in which all distances are compared: the std version looks around every cell.
const DISTANCES_EVERY: u64 = 25;

/// Memory of core's side, and its sensor.
#[derive(Debug)]
pub struct EvidenceStorage {
    sensors: [SensorConfig; 1],
    cells: Vec<EvidenceU16>,
    classes: Vec<u8>,
    limits: Vec<BeamLimits>,
    binary: Vec<u32>,
    squared: Vec<u16>,
    vertices: Vec<EnvelopeVertex>,
}

impl EvidenceStorage {
    /// Memory for a configuration, scans of at most `beams` beams, and a sensor at `mount` on the robot.
    ///
    /// # Errors
    /// As [`EvidenceConfig::validate`].
    pub fn new(config: &EvidenceConfig, beams: usize, mount: Pose2D) -> Result<Self, LockstepError> {
        config.validate()?;
        let (width, height) = (config.width, config.height);
        Ok(Self {
            sensors: [SensorConfig {
                lattice: config.lattice("robot")?,
                mount,
                model: config.model,
            }],
            cells: vec![EvidenceU16::default(); config.cells()],
            classes: vec![0; class_bytes(width, height)],
            limits: vec![BeamLimits::EMPTY; beams],
            binary: vec![0; bitmap_words(width, height)],
            squared: vec![0; config.cells()],
            vertices: vec![EnvelopeVertex::EMPTY; width as usize],
        })
    }

    /// Bytes that core works in.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.cells[..])
            + size_of_val(&self.classes[..])
            + size_of_val(&self.limits[..])
            + size_of_val(&self.binary[..])
            + size_of_val(&self.squared[..])
            + size_of_val(&self.vertices[..])
    }
}

/// What a run has counted so far.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct EvidenceTotals {
    /// Ticks compared.
    pub ticks: u64,
    /// Mass, binary and distance cells compared.
    pub cells_compared: u64,
    /// Masses beyond the bound, binary cells that differ away from a threshold, distances that differ, and windows and
    /// refusals that do.
    pub mismatches: u64,
    /// The largest difference of a mass.
    pub largest_difference: f64,
    /// Cells in which a scan contradicted the map, over all ticks.
    pub conflicts: u64,
    /// The first mismatch in words.
    pub first_mismatch: Option<String>,
    /// Time core took for its ticks.
    pub core_time: Duration,
    /// The same for the std version, distances apart.
    pub std_time: Duration,
}

/// Core and std version of local mapping, fed and compared tick by tick.
pub struct EvidenceLockstep<'a> {
    config: EvidenceConfig,
    core: LocalMapping<'a>,
    std: std_version::LocalMapping,
    totals: EvidenceTotals,
}

impl<'a> EvidenceLockstep<'a> {
    /// Both sides, which know nothing; the frame's origin lies in the middle of the map.
    ///
    /// # Errors
    /// As [`EvidenceConfig::validate`], and if the storage was made for another configuration.
    pub fn new(config: &EvidenceConfig, storage: &'a mut EvidenceStorage) -> Result<Self, LockstepError> {
        config.validate()?;
        let lattice = config.lattice("odom")?;
        let buffers = MappingBuffers {
            cells: &mut storage.cells,
            classes: &mut storage.classes,
            limits: &mut storage.limits,
            binary: &mut storage.binary,
            distance: DistanceBuffers {
                cells: &mut storage.squared[..],
                vertices: &mut storage.vertices[..],
            },
        };
        let mapping = LocalMappingConfig {
            lattice,
            rule: config.rule,
            sensors: &storage.sensors,
            inpaint: &[],
            thresholds: config.thresholds,
            max_distance: config.max_distance,
        };
        Ok(Self {
            config: *config,
            core: LocalMapping::new_in(buffers, mapping)?,
            std: std_version::LocalMapping::new(config.std(&lattice, storage.sensors[0].mount)),
            totals: EvidenceTotals::default(),
        })
    }

    /// One tick: both sides move their window to the robot (metres and radians in the map's frame) and fuse the scan;
    /// then all cells are compared. Returns the reason if core refused; the maps stay as they were then.
    pub fn tick(&mut self, scan: &LaserScan<'_>, robot: Pose2D) -> Option<String> {
        let (angles, ranges) = beams(scan);
        let flat = Flatscan {
            angles: &angles,
            ranges: &ranges,
            invalid_range_threshold: scan.range_min,
            out_of_range_threshold: scan.range_max,
            visibilities: None,
        };
        let start = Instant::now();
        let core = self.core.tick(
            &[SensorScan {
                sensor: 0,
                scan: flat,
            }],
            robot,
        );
        self.totals.core_time += start.elapsed();
        let report = match core {
            Ok(report) => report,
            Err(error) => return Some(error.to_string()),
        };
        self.totals.conflicts += u64::from(report.fusion.conflicts);

        let flat = std_version::Flatscan {
            angles: angles.clone(),
            ranges: ranges.clone(),
            invalid_range_threshold: scan.range_min,
            out_of_range_threshold: scan.range_max,
            visibilities: None,
        };
        let start = Instant::now();
        let shift = self.std.tick(&[(0, flat)], [robot.x, robot.y, robot.theta]);
        self.totals.std_time += start.elapsed();
        if shift != Some(report.shift) {
            self.note(1, || {
                format!("the window moved by {:?}, std version: {shift:?}", report.shift)
            });
        }
        self.compare();
        self.totals.ticks += 1;
        None
    }

    fn compare(&mut self) {
        let (bound, width) = (self.config.bound(), self.config.width.max(1));
        let thresholds = self.config.thresholds;
        let std_binary = self.std.binary();
        let (mut beyond, mut cut, mut most, mut first) = (0, 0, 0.0f64, None);
        for (i, ((core, std), occupied)) in self
            .core
            .evidence()
            .cells()
            .iter()
            .zip(&self.std.cells)
            .zip(&std_binary)
            .enumerate()
        {
            let [f, o] = parts(*core);
            let off = (f - std.free).abs().max((o - std.occupied).abs());
            most = most.max(off);
            let (gx, gy) = (i as u32 % width, i as u32 / width);
            let near = |mass: f64, threshold: f32| (mass - f64::from(threshold)).abs() <= bound;
            let undecided = near(std.free, thresholds.free_threshold)
                || near(std.occupied, thresholds.occupied_threshold);
            let differs = !undecided && self.core.binary().is_occupied(gx, gy) != Some(*occupied);
            beyond += u64::from(off > bound);
            cut += u64::from(differs);
            if (off > bound || differs) && first.is_none() {
                first = Some(format!("cell ({gx}, {gy}): core {core:?}, std version {std:?}"));
            }
        }
        self.totals.largest_difference = self.totals.largest_difference.max(most);
        self.totals.cells_compared += 2 * self.std.cells.len() as u64;
        self.note(beyond + cut, || first.unwrap_or_default());
        if self.totals.ticks.is_multiple_of(DISTANCES_EVERY) {
            let core = self.core.distance().squared();
            let expected = self.squared(&self.core_binary());
            let differing = core
                .iter()
                .zip(&expected)
                .filter(|(a, b)| u32::from(**a) != **b)
                .count() as u64;
            self.totals.cells_compared += expected.len() as u64;
            self.note(differing, || format!("{differing} distances differ"));
        }
    }

    fn note(&mut self, mismatches: u64, what: impl FnOnce() -> String) {
        if mismatches > 0 {
            self.totals.mismatches += mismatches;
            let tick = self.totals.ticks;
            self.totals
                .first_mismatch
                .get_or_insert_with(|| format!("tick {tick}: {}", what()));
        }
    }

    fn core_binary(&self) -> Vec<bool> {
        (0..self.config.height)
            .flat_map(|gy| self.core.binary().row(gy))
            .collect()
    }

    fn squared(&self, binary: &[bool]) -> Vec<u32> {
        let cells = self.config.max_distance / self.config.resolution;
        // As many cells as it was meant to be, if nearly that many.
        let is_whole = (cells - cells.round()).abs() <= 1.0 / 1024.0;
        let cells = if is_whole { cells.round() } else { cells };
        let cap = (cells * cells).ceil().min(65_535.0) as u32;
        let width = self.config.width.max(1) as usize;
        (0..binary.len())
            .map(|i| distance::squared(binary, width, i, cap))
            .collect()
    }

    /// What has been counted so far.
    pub fn totals(&self) -> &EvidenceTotals {
        &self.totals
    }

    /// Core's maps after the last tick.
    pub fn core_layers(&self) -> EvidenceLayers {
        EvidenceLayers {
            offset: self.core.info().offset(),
            masses: self
                .core
                .evidence()
                .cells()
                .iter()
                .map(|cell| parts(*cell))
                .collect(),
            binary: self.core_binary(),
            distance: self.core.distance().metres().collect(),
        }
    }

    /// The std version's maps after the last tick.
    pub fn std_layers(&self) -> EvidenceLayers {
        let binary = self.std.binary();
        let metres = |squared: &u32| self.config.resolution * libm::sqrtf(*squared as f32);
        EvidenceLayers {
            offset: self.std.offset,
            masses: self.std.cells.iter().map(|m| [m.free, m.occupied]).collect(),
            distance: self.squared(&binary).iter().map(metres).collect(),
            binary,
        }
    }
}

/// Free and occupied of a cell, exactly.
fn parts(cell: EvidenceU16) -> [f64; 2] {
    [cell.free_steps(), cell.occupied_steps()].map(|steps| f64::from(steps) / f64::from(EvidenceU16::FULL))
}

/// Angles and ranges of a scan, in ascending order of the angles.
fn beams(scan: &LaserScan<'_>) -> (Vec<f32>, Vec<f32>) {
    let angle = |i: usize| (f64::from(scan.angle_min) + i as f64 * f64::from(scan.angle_increment)) as f32;
    let mut angles: Vec<f32> = (0..scan.ranges.len()).map(angle).collect();
    let mut ranges = scan.ranges.to_vec();
    if scan.angle_increment < 0.0 {
        angles.reverse();
        ranges.reverse();
    }
    (angles, ranges)
}
