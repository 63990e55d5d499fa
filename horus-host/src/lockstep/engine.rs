use std::fmt::{Debug, Display};
use std::time::Instant;

use horus_core::prelude::{LaserScan, Pose2D};

use super::comparison;
use super::core_side::CoreSide;
use super::local::LocalInput;
use super::std_side::{self, StdSide};
use super::{CoreStorage, Layer, Layers, LockstepConfig, LockstepError, Mismatch, Totals};

/// Core and std version of one map, fed and compared tick by tick.
pub struct Lockstep<'a> {
    config: LockstepConfig,
    core: CoreSide<'a>,
    std: StdSide,
    core_layers: Layers,
    std_layers: Layers,
    totals: Totals,
    first_mismatch: Option<Mismatch>,
}

impl<'a> Lockstep<'a> {
    /// Both sides with every cell unknown, the frame's origin in the middle of the map.
    ///
    /// # Errors
    /// As [`CoreStorage::new`]; an error too if the storage was made for another configuration.
    pub fn new(config: &LockstepConfig, storage: &'a mut CoreStorage) -> Result<Self, LockstepError> {
        config.validate()?;
        Ok(Self {
            config: *config,
            core: CoreSide::new(config, config.origin(), storage)?,
            std: StdSide::new(config)?,
            core_layers: Layers::new(config.cells()),
            std_layers: Layers::new(config.cells()),
            totals: Totals::default(),
            first_mismatch: None,
        })
    }

    /// One tick: both sides move their window to the robot, integrate the scan seen from the
    /// sensor (poses in metres and radians in the map's frame) and update their costs; then all
    /// cells are compared.
    ///
    /// A pose or scan that a side refuses leaves that side's map as it was. Returns the reason if
    /// both refused; if only one did, it is a mismatch.
    ///
    /// # Complexity
    /// That of the std version: every cell within reach of every source.
    pub fn tick(
        &mut self,
        stamp_ns: u64,
        scan: &LaserScan<'_>,
        robot: Pose2D,
        sensor: Pose2D,
    ) -> Option<String> {
        if self.config.local.is_some() {
            return self.tick_local(stamp_ns, &LocalInput::new(scan, robot, sensor));
        }
        let std_scan = std_side::scan(scan); // a copy, made before the clock starts

        let start = Instant::now();
        let core_shift = self.core.recenter(robot);
        let core_report = self.core.integrate(scan, sensor);
        self.core.update_costs();
        self.totals.core_time += start.elapsed();

        let start = Instant::now();
        let std_shift = self.std.recenter(robot);
        let std_report = self.std.integrate(&std_scan, sensor);
        self.std.compute_costs();
        self.totals.std_time += start.elapsed();

        let refused_shift = self.agree(Layer::Window, stamp_ns, core_shift, std_shift);
        let refused_scan = self.agree(Layer::ScanReport, stamp_ns, core_report, std_report);
        self.compare(stamp_ns);
        refused_shift.or(refused_scan)
    }

    /// [`tick`](Self::tick) of a local map.
    fn tick_local(&mut self, stamp_ns: u64, input: &LocalInput) -> Option<String> {
        let std_state = input.std_state();

        let start = Instant::now();
        let core_update = self.core.update_local(input);
        self.core.update_costs();
        self.totals.core_time += start.elapsed();

        let start = Instant::now();
        let std_update = self.std.update_local(input, &std_state);
        self.std.compute_costs();
        self.totals.std_time += start.elapsed();

        let refused = self.agree(Layer::ScanReport, stamp_ns, core_update, std_update);
        self.compare(stamp_ns);
        refused
    }

    /// What has been counted so far.
    pub fn totals(&self) -> &Totals {
        &self.totals
    }

    /// The first disagreement so far.
    pub fn first_mismatch(&self) -> Option<&Mismatch> {
        self.first_mismatch.as_ref()
    }

    /// The core's map after the last tick; without cells before the first.
    pub fn core_layers(&self) -> &Layers {
        &self.core_layers
    }

    /// The std version's map after the last tick; without cells before the first.
    pub fn std_layers(&self) -> &Layers {
        &self.std_layers
    }

    /// Compares what two calls returned; the reason if both were refused.
    fn agree<T: Debug + PartialEq, E: Display, R: Display>(
        &mut self,
        layer: Layer,
        stamp_ns: u64,
        core: Result<T, E>,
        std: Result<T, R>,
    ) -> Option<String> {
        let (layer, core, std) = match (core, std) {
            (Ok(core), Ok(std)) if core == std => return None,
            (Err(core), Err(_)) => return Some(core.to_string()),
            (Ok(core), Ok(std)) => (layer, format!("{core:?}"), format!("{std:?}")),
            (Ok(core), Err(std)) => (Layer::Refusal, format!("{core:?}"), std.to_string()),
            (Err(core), Ok(std)) => (Layer::Refusal, core.to_string(), format!("{std:?}")),
        };
        self.note(Mismatch {
            layer,
            tick: self.totals.ticks,
            stamp_ns,
            cell: None,
            core,
            std,
            picture: String::new(),
        });
        None
    }

    fn compare(&mut self, stamp_ns: u64) {
        self.core.read(&mut self.core_layers);
        self.std.read(&mut self.std_layers);
        let (core, std) = (self.core_layers.offset, self.std_layers.offset);
        if core != std {
            self.note(Mismatch {
                layer: Layer::Window,
                tick: self.totals.ticks,
                stamp_ns,
                cell: None,
                core: format!("{core:?}"),
                std: format!("{std:?}"),
                picture: String::new(),
            });
        }
        let comparison = comparison::compare(
            &self.core_layers,
            &self.std_layers,
            self.config.width,
            self.config.params.lethal_cost,
            (self.totals.ticks, stamp_ns),
        );
        self.totals.ticks += 1;
        self.totals.cells_compared += 2 * self.config.cells() as u64;
        self.totals.mismatches += comparison.differing;
        if let Some(first) = comparison.first {
            self.first_mismatch.get_or_insert(first);
        }
    }

    fn note(&mut self, mismatch: Mismatch) {
        self.totals.mismatches += 1;
        self.first_mismatch.get_or_insert(mismatch);
    }
}
