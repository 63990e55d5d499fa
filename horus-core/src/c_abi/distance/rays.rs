use nalgebra::UnitComplex;

use crate::c_abi::call::{Call, Plain};
use crate::c_abi::geometry::horus_cell;
use crate::c_abi::grid::{Grid, horus_grid};
use crate::c_abi::grid_reads::view;
use crate::c_abi::status::horus_status;
use crate::geometry::Pose2D;
use crate::raycast::{RayCaster, WalkRule};

/// Which cells a ray between two cells visits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum horus_walk_rule {
    /// One per step along the longer side; exactly between two cells, the one nearer to the start.
    Standard = 0,
    /// Every cell that the line between the two centres touches.
    Supercover = 1,
    /// As standard, but exactly between two cells the one farther from the start.
    Navground = 2,
}

/// A ray through a grid.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct horus_ray {
    /// Where it starts, world frame.
    pub pose: Pose2D,
    /// Its direction, radians counter-clockwise from the pose's heading.
    pub bearing: f32,
    /// How far it goes, metres.
    pub range: f32,
    /// A horus_walk_rule.
    pub rule: i32,
}

// SAFETY: numbers.
unsafe impl Plain for horus_ray {}
// SAFETY: numbers.
unsafe impl Plain for horus_cell {}

impl horus_ray {
    /// Calls `body` with the caster and the bearing of this ray.
    fn cast<R>(
        &self,
        grid: &Grid,
        body: impl FnOnce(RayCaster<'_, Grid>, UnitComplex<f32>) -> R,
    ) -> Result<R, horus_status> {
        let rule = match self.rule {
            r if r == horus_walk_rule::Standard as i32 => WalkRule::Standard,
            r if r == horus_walk_rule::Supercover as i32 => WalkRule::Supercover,
            r if r == horus_walk_rule::Navground as i32 => WalkRule::Navground,
            _ => return Err(horus_status::InvalidChoice),
        };
        let rays = RayCaster::new(grid, self.pose.isometry(), self.range, rule);
        Ok(body(rays, UnitComplex::new(self.bearing)))
    }
}

/// Metres to the first cell of a ray that is not free, the one it starts in included: centre to
/// centre, at most the range. *hit tells whether there is one; if not, *metres is the range.
///
/// Nothing is hit outside the grid, by a ray of numbers that are not finite, and by one that ends
/// more than 2^30 cells away. Fails with HORUS_STATUS_INVALID_CHOICE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_cast(
    grid: *const horus_grid,
    ray: *const horus_ray,
    hit: *mut bool,
    metres: *mut f32,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let grid = view(claims, grid)?;
        let ray = claims.input(ray)?;
        let (hit, metres) = (claims.output(hit)?, claims.output(metres)?);
        let distance = ray.cast(grid, |rays, bearing| rays.cast(bearing))?;
        hit.write(distance.is_some());
        metres.write(distance.unwrap_or(ray.range));
        Ok(())
    })
}

/// The cells of a ray, from the one it starts in to the last one inside the grid: *count of them at
/// `cells`. A grid of width * height cells has room for all in 2 * (width + height).
///
/// Fails with HORUS_STATUS_INVALID_CHOICE, HORUS_STATUS_BUFFER_TOO_SMALL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn horus_grid_trace(
    grid: *const horus_grid,
    ray: *const horus_ray,
    cells: *mut horus_cell,
    capacity: usize,
    count: *mut usize,
) -> horus_status {
    // SAFETY: the pointers are the caller's.
    unsafe { Call::from_c() }.run(|claims| {
        let grid = view(claims, grid)?;
        let ray = claims.input(ray)?;
        let (cells, count) = (claims.slice_mut(cells, capacity)?, claims.output(count)?);
        let visited = ray.cast(grid, |rays, bearing| {
            let number = rays.trace(bearing).count();
            let room = cells.get_mut(..number).ok_or(horus_status::BufferTooSmall)?;
            for (to, cell) in room.iter_mut().zip(rays.trace(bearing)) {
                // Inside the grid: not negative.
                (to.gx, to.gy) = (cell.x as u32, cell.y as u32);
            }
            Ok::<_, horus_status>(number)
        })??;
        count.write(visited);
        Ok(())
    })
}
