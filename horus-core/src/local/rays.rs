//! Drawing a lidar's scan.

use super::frame::Frame;
use super::lidar::ScanView;
use super::{FREE, OCCUPIED};
use crate::geometry::Pose2D;
use crate::grid::{BeamSlot, ScanWorkspace};
use crate::math;
use crate::walk::{End, Far, GridWalk};

/// The shortest range that marks a cell, in metres.
const MIN_MARK: f32 = 0.01;
/// Ranges nearer than this to the longest one are misses, in metres.
const MISS_MARGIN: f64 = 1e-3;

/// What drawing a scan did.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Drawn {
    /// Beams that marked a cell of the map.
    pub marks: u32,
    /// Beams that are NaN or -inf.
    pub ignored: u32,
}

/// Frees the cells of all rays, then marks the cells where they ended.
pub(super) fn draw(
    cells: &mut [u8],
    frame: &Frame,
    scan: &ScanView<'_>,
    robot: Pose2D,
    workspace: &mut ScanWorkspace<'_>,
) -> Drawn {
    let sensor = mounted(robot, scan.mount);
    let from = [sensor.x, sensor.y];
    let start = frame.cell(sensor.x, sensor.y);
    let (c, s) = math::cos_sin(sensor.theta);
    let miss = (f64::from(scan.max_range) - MISS_MARGIN) as f32;
    let mut drawn = Drawn::default();

    let slots = workspace.directed(scan.ranges.len(), scan.angles());
    for (slot, &range) in slots.iter_mut().zip(scan.ranges) {
        slot.hit = BeamSlot::NO_CELL;
        let range = if range.is_finite() {
            range
        } else if range == f32::INFINITY {
            scan.max_range
        } else {
            drawn.ignored += 1;
            continue;
        };
        let u = slot.direction;
        let (dx, dy) = (c * u.x - s * u.y, s * u.x + c * u.y);
        if let Some(start) = start {
            let reach = range - frame.resolution;
            let [x, y] = frame.clip(from, [dx * reach, dy * reach]);
            let walk = frame.cell(x, y).and_then(|end| {
                GridWalk::new::<Far>(start, end, End::Included, frame.size[0], frame.size[1])
            });
            if let Some(walk) = walk {
                free(cells, walk);
            }
        }
        if MIN_MARK <= range
            && range < miss
            && let Some(hit) = frame.cell(from[0] + dx * range, from[1] + dy * range)
        {
            slot.hit = frame.index(hit) as u32;
        }
    }
    for slot in slots.iter().filter(|slot| slot.hit != BeamSlot::NO_CELL) {
        if let Some(cell) = cells.get_mut(slot.hit as usize) {
            *cell = OCCUPIED;
            drawn.marks += 1;
        }
    }
    drawn
}

/// Frees the cells of a ray. Not inlined: beside the arithmetic of beams the loop would have too few
/// registers.
#[inline(never)]
fn free(cells: &mut [u8], walk: GridWalk) {
    walk.for_each(|i| {
        if let Some(cell) = cells.get_mut(i) {
            *cell = FREE;
        }
    });
}

/// Where a sensor mounted on the robot stands.
fn mounted(robot: Pose2D, mount: Pose2D) -> Pose2D {
    let (c, s) = math::cos_sin(robot.theta);
    Pose2D::new(
        robot.x + (c * mount.x - s * mount.y),
        robot.y + (s * mount.x + c * mount.y),
        robot.theta + mount.theta,
    )
}
