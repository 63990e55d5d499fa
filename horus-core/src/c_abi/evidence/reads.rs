//! Reading the stages of a local mapping.

use super::config::{horus_masses, operator};
use super::mapping::{Mapping, horus_local_mapping};
use crate::c_abi::call::{Call, Plain};
use crate::c_abi::grid::horus_map_info;
use crate::c_abi::status::{horus_status, inside};
use crate::evidence::{EvidenceU16, FusionRule, Masses, ScanClass, evidence_to_occupancy, fuse};

/// A mass cell: free and occupied in steps of 1 / 65535; what they leave of 65535 is uncertain.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct horus_evidence_cell {
    /// Mass free.
    pub free: u16,
    /// Mass occupied, at most 65535 - free.
    pub occupied: u16,
}

// SAFETY: two numbers.
unsafe impl Plain for horus_evidence_cell {}

impl horus_evidence_cell {
    fn cell(self) -> Result<EvidenceU16, horus_status> {
        EvidenceU16::from_steps(self.free, self.occupied).ok_or(horus_status::InvalidMasses)
    }
}

impl From<EvidenceU16> for horus_evidence_cell {
    fn from(cell: EvidenceU16) -> Self {
        Self {
            free: cell.free_steps(),
            occupied: cell.occupied_steps(),
        }
    }
}

impl From<Masses> for horus_masses {
    fn from(masses: Masses) -> Self {
        Self {
            free: masses.free(),
            occupied: masses.occupied(),
        }
    }
}

/// What a scan says about a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum horus_scan_class {
    /// Nothing: no beam covers it, or it lies behind the hit.
    Vacuous = 0,
    /// Before the hit.
    Free = 1,
    /// At the hit.
    Occupied = 2,
}

/// Size, resolution and place of the fused map.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_mapping_info(
    mapping: *const horus_local_mapping,
    info: *mut horus_map_info,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let mapping = claims.object::<Mapping>(mapping)?;
        claims.output(info)?.write(mapping.info().into());
        Ok(())
    })
}

/// Size, resolution and place of the window that the distances are of: after
/// horus_local_mapping_tick_within, that of the tick which began their stage.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_mapping_distance_info(
    mapping: *const horus_local_mapping,
    info: *mut horus_map_info,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let mapping = claims.object::<Mapping>(mapping)?;
        claims.output(info)?.write(mapping.distance_info().into());
        Ok(())
    })
}

/// A cell of the fused map, before painting.
///
/// Fails with HORUS_STATUS_OUTSIDE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_mapping_evidence(
    mapping: *const horus_local_mapping,
    gx: u32,
    gy: u32,
    cell: *mut horus_evidence_cell,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let mapping = claims.object::<Mapping>(mapping)?;
        let cell = claims.output(cell)?;
        cell.write(inside(mapping.evidence().cell_at(gx, gy))?.into());
        Ok(())
    })
}

/// The masses of a cell after painting.
///
/// Fails with HORUS_STATUS_OUTSIDE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_mapping_masses(
    mapping: *const horus_local_mapping,
    gx: u32,
    gy: u32,
    masses: *mut horus_masses,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let mapping = claims.object::<Mapping>(mapping)?;
        let masses = claims.output(masses)?;
        masses.write(inside(mapping.inpainted_at(gx, gy))?.into());
        Ok(())
    })
}

/// Whether a cell of the binary map is occupied.
///
/// Fails with HORUS_STATUS_OUTSIDE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_mapping_is_occupied(
    mapping: *const horus_local_mapping,
    gx: u32,
    gy: u32,
    occupied: *mut bool,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let mapping = claims.object::<Mapping>(mapping)?;
        let occupied = claims.output(occupied)?;
        occupied.write(inside(mapping.binary().is_occupied(gx, gy))?);
        Ok(())
    })
}

/// Metres from a cell to the nearest occupied one, in the window of horus_local_mapping_distance_info.
///
/// Fails with HORUS_STATUS_OUTSIDE, also while a distance stage has not ended.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_mapping_distance(
    mapping: *const horus_local_mapping,
    gx: u32,
    gy: u32,
    metres: *mut f32,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let mapping = claims.object::<Mapping>(mapping)?;
        let metres = claims.output(metres)?;
        metres.write(inside(mapping.distance().metres_at(gx, gy))?);
        Ok(())
    })
}

/// What the scan that was fused last says about a cell of its sensor's lattice, a horus_scan_class:
/// outside, and before the first scan, vacuous. `sensor`, which may be NULL, takes that sensor's index; -1:
/// there was no scan.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_mapping_scan_class(
    mapping: *const horus_local_mapping,
    row: u32,
    col: u32,
    scan_class: *mut i32,
    sensor: *mut i32,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let mapping = claims.object::<Mapping>(mapping)?;
        let (scan_class, sensor) = (claims.output(scan_class)?, claims.output_or_null(sensor)?);
        let says = match mapping.class_at(row, col) {
            ScanClass::Vacuous => horus_scan_class::Vacuous,
            ScanClass::Free => horus_scan_class::Free,
            ScanClass::Occupied => horus_scan_class::Occupied,
        };
        scan_class.write(says as i32);
        sensor.write(mapping.last_sensor().map_or(-1, |i| i as i32));
        Ok(())
    })
}

/// Occupancy values of the fused map, before painting, row by row: the probability that a cell is
/// occupied in percent, or -1 where more than `max_uncertain` is uncertain. What horus_cost_map_load
/// takes.
///
/// Fails with HORUS_STATUS_LENGTH_MISMATCH unless count is the number of cells,
/// HORUS_STATUS_INVALID_MAPPING_PARAMETER.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_mapping_occupancy(
    mapping: *const horus_local_mapping,
    max_uncertain: f32,
    values: *mut i8,
    count: usize,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let cells = claims.object::<Mapping>(mapping)?.evidence().cells();
        if count != cells.len() {
            return Err(horus_status::LengthMismatch);
        }
        let values = claims.slice_mut(values, count)?;
        Ok(evidence_to_occupancy(cells, max_uncertain, values)?)
    })
}

/// Fuses two mass cells by a horus_fusion_operator. `conflict`, which may be NULL, takes the mass in
/// conflict.
///
/// Fails with HORUS_STATUS_INVALID_CHOICE, HORUS_STATUS_INVALID_MASSES,
/// HORUS_STATUS_INVALID_MAPPING_PARAMETER.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_evidence_fuse(
    fusion: i32,
    ignorance_floor: f32,
    one: horus_evidence_cell,
    two: horus_evidence_cell,
    fused: *mut horus_evidence_cell,
    conflict: *mut f32,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let (fused, conflict) = (claims.output(fused)?, claims.output_or_null(conflict)?);
        let rule = FusionRule {
            operator: operator(fusion)?,
            ignorance_floor,
        };
        let (mut state, sensor) = ([one.cell()?], [two.cell()?]);
        let report = fuse(rule, &mut state, &sensor)?;
        let [state] = state;
        fused.write(state.into());
        conflict.write(report.conflict_mass);
        Ok(())
    })
}
