//! A tick of local mapping.

use super::mapping::{Mapping, horus_local_mapping};
use crate::c_abi::call::{Call, Claims, Plain};
use crate::c_abi::geometry::horus_shift;
use crate::c_abi::status::horus_status;
use crate::error::Error;
use crate::evidence::{Flatscan, SensorScan, TickReport};
use crate::geometry::Pose2D;

/// One sweep of a range sensor with beams at any angles. Ranges are metres: NaN and -inf say nothing,
/// +inf is no hit.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct horus_flatscan {
    /// Directions of the beams in the sensor's frame, radians, ascending.
    pub angles: *const f32,
    /// One range per beam.
    pub ranges: *const f32,
    /// How far each beam could see, metres; NULL if that is not known.
    pub visibilities: *const f32,
    /// Beams.
    pub count: usize,
    /// Index of the sensor in the configuration.
    pub sensor: u32,
    /// Ranges up to this say nothing.
    pub invalid_range_threshold: f32,
    /// Ranges from this on are no hit.
    pub out_of_range_threshold: f32,
}

// SAFETY: numbers, and pointers that are claimed before they are followed.
unsafe impl Plain for horus_flatscan {}

/// What a tick did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct horus_tick_report {
    /// Whole cells by which the window moved.
    pub shift: horus_shift,
    /// Cells in which the scan contradicted the map.
    pub conflicts: u32,
    /// The mass in conflict, over all cells.
    pub conflict_mass: f32,
    /// Cells that became vacuous in a total conflict (Dempster's rule).
    pub undefined: u32,
    /// Rows of distances that still wait; 0: they can be read.
    pub distance_rows_left: u32,
}

impl From<TickReport> for horus_tick_report {
    fn from(report: TickReport) -> Self {
        Self {
            shift: report.shift.into(),
            conflicts: report.fusion.conflicts,
            conflict_mass: report.fusion.conflict_mass,
            undefined: report.fusion.undefined,
            distance_rows_left: report.distance_rows_left,
        }
    }
}

/// Claims a scan, if there is one, and ticks.
fn run(
    claims: &mut Claims<'_>,
    mapping: *mut horus_local_mapping,
    scan: *const horus_flatscan,
    report: *mut horus_tick_report,
    tick: impl FnOnce(&mut Mapping, &[SensorScan<'_>]) -> Result<TickReport, Error>,
) -> Result<(), horus_status> {
    let mapping = claims.object_mut::<Mapping>(mapping)?;
    let report = claims.output_or_null(report)?;
    if scan.is_null() {
        report.write(tick(mapping, &[])?.into());
        return Ok(());
    }
    let scan = claims.input(scan)?;
    let visibilities = if scan.visibilities.is_null() {
        None
    } else {
        Some(claims.slice(scan.visibilities, scan.count)?)
    };
    let scan = SensorScan {
        sensor: scan.sensor as usize,
        scan: Flatscan {
            angles: claims.slice(scan.angles, scan.count)?,
            ranges: claims.slice(scan.ranges, scan.count)?,
            invalid_range_threshold: scan.invalid_range_threshold,
            out_of_range_threshold: scan.out_of_range_threshold,
            visibilities,
        },
    };
    report.write(tick(mapping, &[scan])?.into());
    Ok(())
}

/// One tick of the whole chain: moves the window to the robot (its pose in the world), fuses a scan
/// (NULL: none), paints, cuts and measures. `report` may be NULL. For scans of several sensors tick
/// once for each.
///
/// Fails with HORUS_STATUS_NON_FINITE_POSE, HORUS_STATUS_OFFSET_OUT_OF_RANGE,
/// HORUS_STATUS_INVALID_SCAN, HORUS_STATUS_EMPTY_SCAN, HORUS_STATUS_WORKSPACE_TOO_SMALL,
/// HORUS_STATUS_UNKNOWN_SENSOR, HORUS_STATUS_SENSOR_OUTSIDE_MAP.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_mapping_tick(
    mapping: *mut horus_local_mapping,
    scan: *const horus_flatscan,
    robot: Pose2D,
    report: *mut horus_tick_report,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        run(claims, mapping, scan, report, |mapping, scans| {
            mapping.tick(scans, robot)
        })
    })
}

/// As horus_local_mapping_tick, but does at most `rows` rows of the distance stage, which takes
/// 2 * height of them. A stage once begun is finished by later ticks before another begins.
///
/// Fails as horus_local_mapping_tick does.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_mapping_tick_within(
    mapping: *mut horus_local_mapping,
    scan: *const horus_flatscan,
    robot: Pose2D,
    rows: u32,
    report: *mut horus_tick_report,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        run(claims, mapping, scan, report, |mapping, scans| {
            mapping.tick_within(scans, robot, rows)
        })
    })
}
