use super::map::{LocalMap, horus_local_map};
use crate::c_abi::call::Call;
use crate::c_abi::geometry::horus_shift;
use crate::c_abi::status::horus_status;
use crate::geometry::Pose2D;
use crate::local::LocalUpdate;

/// What an update of a local map did.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct horus_local_update {
    /// Cells the window moved.
    pub shift: horus_shift,
    /// The robot's pose in the map's frame that was used.
    pub pose: Pose2D,
    /// 1 if the map has an odometry sensor that has written no pose: the given one was used.
    pub missing_odometries: u32,
    /// Lidars whose scans were drawn.
    pub lidars: u32,
    /// Lidars that have written no scan.
    pub missing_lidars: u32,
    /// Lidars whose scans had no ranges.
    pub empty_lidars: u32,
    /// Beams that marked a cell of the map.
    pub marks: u32,
    /// Beams that were NaN or -inf.
    pub ignored: u32,
}

impl From<LocalUpdate> for horus_local_update {
    fn from(update: LocalUpdate) -> Self {
        Self {
            shift: update.shift.into(),
            pose: update.pose,
            missing_odometries: update.missing_odometries,
            lidars: update.lidars,
            missing_lidars: update.missing_lidars,
            empty_lidars: update.empty_lidars,
            marks: update.marks,
            ignored: update.ignored,
        }
    }
}

/// One update: moves the window with the robot, frees the cells under the footprint, and draws the
/// lidars' scans one after the other, of each all free rays, then all marks. `pose` is the robot's in
/// the world; it is also the one in the map's frame where no odometry has been written. `update` may
/// be NULL.
///
/// Fails with HORUS_STATUS_NON_FINITE_POSE, HORUS_STATUS_OFFSET_OUT_OF_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_map_update(
    map: *mut horus_local_map,
    pose: Pose2D,
    update: *mut horus_local_update,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let local = claims.object_mut::<LocalMap>(map)?;
        let update = claims.output_or_null(update)?;
        let told = local.map.update(&local.state, pose, &mut local.workspaces)?;
        update.write(told.into());
        Ok(())
    })
}

/// Copies the map into its sensing state, for those who read it there: one who uses the map itself
/// need not.
///
/// Fails with HORUS_STATUS_BUFFER_TOO_SMALL if it was made without room for that.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_local_map_publish(map: *mut horus_local_map) -> horus_status {
    // SAFETY: the pointer is the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let local = claims.object_mut::<LocalMap>(map)?;
        local.map.publish(&mut local.state)?;
        Ok(())
    })
}
