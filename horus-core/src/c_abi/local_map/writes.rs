use super::map::{LocalMap, horus_local_map};
use crate::c_abi::call::{Call, Plain};
use crate::c_abi::cost_map::{AnyCostMap, horus_cost_map};
use crate::c_abi::geometry::horus_shift;
use crate::c_abi::status::horus_status;
use crate::geometry::Pose2D;
use crate::local::{Lidar, follow};

/// A scan of a lidar whose beams are spread evenly over its field of view.
///
/// Beam i of n points to start_angle + i * fov / (n - 1) radians, counter-clockwise from the sensor's
/// x axis. Ranges are metres: +inf is a miss at max_range; NaN and -inf say nothing.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct horus_lidar_scan {
    /// One range per beam.
    pub ranges: *const f32,
    /// Beams; 0: there is no scan at present.
    pub count: usize,
    /// Where the lidar sits on the robot.
    pub mount: Pose2D,
    /// Angle of the first beam in radians.
    pub start_angle: f32,
    /// Angle between the first beam and the last in radians.
    pub fov: f32,
    /// Longest range in metres.
    pub max_range: f32,
}

// SAFETY: numbers, and a pointer that is claimed before it is followed.
unsafe impl Plain for horus_lidar_scan {}

/// Writes a scan of a lidar, counted from 0, into the map's sensing state; updates draw it until
/// another is written.
///
/// Fails with HORUS_STATUS_OUTSIDE if there is no such lidar, HORUS_STATUS_BUFFER_TOO_SMALL if it has
/// fewer beams, HORUS_STATUS_INVALID_LIDAR, HORUS_STATUS_NON_FINITE_POSE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_map_write_scan(
    map: *mut horus_local_map,
    lidar: u32,
    scan: *const horus_lidar_scan,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let local = claims.object_mut::<LocalMap>(map)?;
        let scan = claims.input(scan)?;
        let name = local.map.config().external_lidars.get(lidar as usize);
        let lidar = Lidar {
            name: name.copied().ok_or(horus_status::Outside)?,
            mount: scan.mount,
            start_angle: scan.start_angle,
            fov: scan.fov,
            max_range: scan.max_range,
        };
        if scan.count > local.beams {
            return Err(horus_status::BufferTooSmall);
        }
        let ranges = claims.slice(scan.ranges, scan.count)?;
        lidar.write(&mut local.state, ranges)?;
        Ok(())
    })
}

/// Writes a pose of the odometry sensor, and its twist per second, into the map's sensing state.
///
/// Fails with HORUS_STATUS_NOT_FOUND if the map has none, HORUS_STATUS_NON_FINITE_POSE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_map_write_odometry(
    map: *mut horus_local_map,
    pose: Pose2D,
    twist: Pose2D,
) -> horus_status {
    // SAFETY: the pointer is the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let local = claims.object_mut::<LocalMap>(map)?;
        let odometry = local.map.config().odometry.ok_or(horus_status::NotFound)?;
        odometry.write(&mut local.state, pose, [twist.x, twist.y, twist.theta])?;
        Ok(())
    })
}

/// Forgets all scans and the odometry's pose.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_map_clear_state(map: *mut horus_local_map) -> horus_status {
    // SAFETY: the pointer is the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        claims.object_mut::<LocalMap>(map)?.state.clear();
        Ok(())
    })
}

/// Makes every cell unknown; the window stays where it is.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_map_clear(map: *mut horus_local_map) -> horus_status {
    // SAFETY: the pointer is the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        claims.object_mut::<LocalMap>(map)?.map.clear();
        Ok(())
    })
}

/// Replaces all cells, row by row: from 192 on free, below 64 occupied, else unknown.
///
/// Fails with HORUS_STATUS_LENGTH_MISMATCH unless count is width * height.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_map_load(
    map: *mut horus_local_map,
    values: *const u8,
    count: usize,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let local = claims.object_mut::<LocalMap>(map)?;
        if count != local.map.info().cells() {
            return Err(horus_status::LengthMismatch);
        }
        local.map.load(claims.slice(values, count)?)?;
        Ok(())
    })
}

/// Moves the window by whole cells so that the pose is nearest to its centre; tells by how many
/// (`shift` may be NULL). An update does this by itself.
///
/// Fails with HORUS_STATUS_NON_FINITE_POSE, HORUS_STATUS_OFFSET_OUT_OF_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_map_recenter(
    map: *mut horus_local_map,
    pose: Pose2D,
    shift: *mut horus_shift,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let local = claims.object_mut::<LocalMap>(map)?;
        let shift = claims.output_or_null(shift)?;
        shift.write(local.map.recenter(pose)?.into());
        Ok(())
    })
}

/// Makes a cost map show the local map: its window moves to where the local map lies, then the cells
/// that differ are set. The cost map has the same size and resolution, and its origin was 0, 0, 0 when
/// it was made. Its costs follow with its next update.
///
/// Fails with HORUS_STATUS_GEOMETRY_MISMATCH.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_map_update_cost_map(
    map: *const horus_local_map,
    cost_map: *mut horus_cost_map,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let local = claims.object::<LocalMap>(map)?;
        let costs = claims.object_mut::<AnyCostMap>(cost_map)?;
        follow(local.map.info(), local.map.data(), costs.operations())?;
        Ok(())
    })
}
