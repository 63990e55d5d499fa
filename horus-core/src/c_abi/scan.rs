//! Laser scans, and what integrating them needs beside a grid.

use core::ffi::c_void;

use super::arena::Arena;
use super::call::{Call, Claims, Plain};
use super::geometry::rect_or_empty;
use super::object::{self, Make, Object};
use super::status::horus_status;
use crate::error::Error;
use crate::geometry::CellRect;
use crate::grid::{BeamSlot, LaserScan, ScanModel, ScanReport, ScanWorkspace};

/// One revolution of a planar lidar: sensor_msgs/LaserScan's fields.
///
/// Beam i points to angle_min + i * angle_increment radians, counter-clockwise from the sensor's x
/// axis. Ranges and limits are metres and follow REP 117: +inf, and from range_max on, is a miss
/// at range_max; NaN, -inf and below range_min say nothing.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct horus_laser_scan {
    /// One range per beam.
    pub ranges: *const f32,
    /// Beams.
    pub count: usize,
    /// Angle of the first beam in radians.
    pub angle_min: f32,
    /// Angle between beams in radians; may be negative.
    pub angle_increment: f32,
    /// Ranges below this are too close to be measured.
    pub range_min: f32,
    /// Ranges from this on are misses.
    pub range_max: f32,
}

// SAFETY: numbers, and a pointer that is claimed before it is followed.
unsafe impl Plain for horus_laser_scan {}

/// How a scan changes the cells it sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum horus_scan_model_kind {
    /// Cleared cells become 0, hit cells 100.
    Set = 0,
    /// Hit cells take one step up, other cleared cells one step down; an unknown cell starts at 50.
    Accumulate = 1,
}

/// How a scan changes cells, and the steps of HORUS_SCAN_MODEL_KIND_ACCUMULATE.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct horus_scan_model {
    /// A horus_scan_model_kind.
    pub kind: i32,
    /// Added to a hit cell, >= 0.
    pub hit: i8,
    /// Added to a cleared cell, <= 0.
    pub miss: i8,
    /// Lowest value that a step leaves, >= 0.
    pub min: i8,
    /// Highest value that a step leaves, <= 100.
    pub max: i8,
}

impl horus_scan_model {
    fn model(self) -> Result<ScanModel, horus_status> {
        let Self {
            hit, miss, min, max, ..
        } = self;
        if self.kind == horus_scan_model_kind::Set as i32 {
            Ok(ScanModel::Set)
        } else if self.kind == horus_scan_model_kind::Accumulate as i32 {
            Ok(ScanModel::Accumulate { hit, miss, min, max })
        } else {
            Err(horus_status::InvalidChoice)
        }
    }
}

/// The model that sets cells to 0 and 100.
#[unsafe(no_mangle)]
pub extern "C" fn horus_scan_model_set() -> horus_scan_model {
    horus_scan_model {
        kind: horus_scan_model_kind::Set as i32,
        hit: 0,
        miss: 0,
        min: 0,
        max: 0,
    }
}

/// The model that accumulates: +20 per hit, -7 per miss, between 0 and 100.
#[unsafe(no_mangle)]
pub extern "C" fn horus_scan_model_accumulate() -> horus_scan_model {
    let mut model = horus_scan_model_set();
    if let ScanModel::Accumulate { hit, miss, min, max } = ScanModel::accumulate() {
        model = horus_scan_model {
            kind: horus_scan_model_kind::Accumulate as i32,
            hit,
            miss,
            min,
            max,
        };
    }
    model
}

/// What a scan did to a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct horus_scan_report {
    /// Smallest rectangle of the cells whose value differs from before; all zero if none does.
    pub changed: CellRect,
    /// Beams that ended at an obstacle, inside the map or not.
    pub hits: u32,
    /// Beams that saw nothing up to range_max.
    pub misses: u32,
    /// Beams without a usable range, or that end more than 2^30 cells away.
    pub ignored: u32,
}

impl From<ScanReport> for horus_scan_report {
    fn from(report: ScanReport) -> Self {
        Self {
            changed: rect_or_empty(report.changed),
            hits: report.hits,
            misses: report.misses,
            ignored: report.ignored,
        }
    }
}

/// What integrating scans of one lidar needs beside the grid: its beams' directions, computed again
/// only when the scan's angles change. Keep one per lidar.
pub struct horus_scan_workspace {
    _memory: (),
}

/// Sizes of a horus_scan_workspace.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct horus_scan_workspace_config {
    /// Most beams a scan may have.
    pub beams: u32,
    /// width * height of the largest grid that scans accumulate in; 0 if they only set cells.
    pub accumulate_cells: u32,
}

// SAFETY: two numbers.
unsafe impl Plain for horus_scan_workspace_config {}

pub(super) type Workspace = ScanWorkspace<'static>;

impl Object for Workspace {
    const TAG: u32 = u32::from_le_bytes(*b"HSw1");
    type Handle = horus_scan_workspace;
}

impl Make for Workspace {
    type Object = Self;
    type Config = horus_scan_workspace_config;
    type Buffers = (&'static mut [BeamSlot], &'static mut [u32]);

    fn buffers(config: &Self::Config, arena: &mut Arena) -> Result<Self::Buffers, horus_status> {
        let beams = arena.take(config.beams as usize)?;
        let seen = arena.take(config.accumulate_cells.div_ceil(32) as usize)?;
        Ok((beams, seen))
    }

    fn make(_: &Self::Config, (beams, seen): Self::Buffers) -> Result<Self, horus_status> {
        Ok(ScanWorkspace::new_in(beams, seen))
    }
}

/// Bytes of memory that such a workspace takes: 12 per beam, one bit per cell, and a few.
///
/// Fails with HORUS_STATUS_SIZE_OVERFLOW.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_scan_workspace_bytes(
    config: *const horus_scan_workspace_config,
    bytes: *mut usize,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let config = claims.input(config)?;
        claims.output(bytes)?.write(object::bytes::<Workspace>(&config)?);
        Ok(())
    })
}

/// Makes a workspace in `length` bytes of memory.
///
/// Fails with HORUS_STATUS_BUFFER_TOO_SMALL, HORUS_STATUS_SIZE_OVERFLOW.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_scan_workspace_init(
    memory: *mut c_void,
    length: usize,
    config: *const horus_scan_workspace_config,
    workspace: *mut *mut horus_scan_workspace,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }
        .run(|claims| object::init::<Workspace>(claims, memory, length, config, workspace))
}

/// The pointers of a scan's integration.
pub(super) struct ScanCall {
    pub scan: *const horus_laser_scan,
    pub model: horus_scan_model,
    pub workspace: *mut horus_scan_workspace,
    pub report: *mut horus_scan_report,
}

impl ScanCall {
    /// Claims everything, integrates, and reports.
    pub(super) fn run(
        self,
        claims: &mut Claims<'_>,
        integrate: impl FnOnce(&LaserScan<'_>, ScanModel, &mut Workspace) -> Result<ScanReport, Error>,
    ) -> Result<(), horus_status> {
        let scan = claims.input(self.scan)?;
        let scan = LaserScan {
            angle_min: scan.angle_min,
            angle_increment: scan.angle_increment,
            range_min: scan.range_min,
            range_max: scan.range_max,
            ranges: claims.slice(scan.ranges, scan.count)?,
        };
        let workspace = claims.object_mut::<Workspace>(self.workspace)?;
        let report = claims.output_or_null(self.report)?;
        report.write(integrate(&scan, self.model.model()?, workspace)?.into());
        Ok(())
    }
}
