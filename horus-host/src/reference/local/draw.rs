use super::super::{ReferenceError, walk_inside};
use super::frame::LocalFrame;
use super::{FREE, LidarScan, LocalUpdate, OCCUPIED};

/// Draws a scan of a robot at `robot` (x, y, theta): all free rays, then all marks.
pub(super) fn draw(
    data: &mut [u8],
    frame: &LocalFrame,
    scan: &LidarScan,
    robot: [f32; 3],
    update: &mut LocalUpdate,
) -> Result<(), ReferenceError> {
    let [x, y, theta] = robot;
    let [mx, my, mount_theta] = scan.mount.to_f32().ok_or(ReferenceError::Pose("mounting pose"))?;
    let (c, s) = (libm::cosf(theta), libm::sinf(theta));
    let sensor = [x + (c * mx - s * my), y + (s * mx + c * my)];
    let yaw = theta + mount_theta;
    let (c, s) = (libm::cosf(yaw), libm::sinf(yaw));
    let mark_below = (f64::from(scan.max_range) - 1e-3) as f32;

    let mut marks = Vec::new();
    for (i, &range) in scan.ranges.iter().enumerate() {
        if range.is_nan() || range == f32::NEG_INFINITY {
            update.ignored += 1;
            continue;
        }
        let range = if range == f32::INFINITY {
            scan.max_range
        } else {
            range
        };
        let [ux, uy] = scan.direction(i);
        let direction = [c * ux - s * uy, s * ux + c * uy];
        for [gx, gy] in free_ray(frame, sensor, direction, range) {
            data[(gy * frame.size[0] + gx) as usize] = FREE;
        }
        if 0.01_f32 <= range && range < mark_below {
            marks.extend(frame.cell([0, 1].map(|axis| sensor[axis] + direction[axis] * range)));
        }
    }
    for [gx, gy] in marks {
        data[(gy * frame.size[0] + gx) as usize] = OCCUPIED;
        update.marks += 1;
    }
    Ok(())
}

/// The cells from the sensor's to the one a cell's length before the range, cut at the map's border.
fn free_ray(frame: &LocalFrame, sensor: [f32; 2], direction: [f32; 2], range: f32) -> Vec<[u32; 2]> {
    let d = direction.map(|part| part * (range - frame.resolution));
    let mut end = [sensor[0] + d[0], sensor[1] + d[1]];
    for axis in [0, 1] {
        let other = 1 - axis;
        if end[axis] < frame.low(axis) {
            let t = (frame.low(axis) - sensor[axis]) / d[axis];
            end[axis] = frame.low(axis);
            end[other] = sensor[other] + d[other] * t;
        } else if end[axis] > frame.high(axis) {
            let t = (frame.high(axis) - sensor[axis]) / d[axis];
            end[axis] = frame.high(axis) - 0.001;
            end[other] = sensor[other] + d[other] * t;
        }
    }
    let (Some(from), Some(to)) = (frame.cell(sensor), frame.cell(end)) else {
        return Vec::new();
    };
    let signed = |cell: [u32; 2]| cell.map(|c| c as i32);
    let cells = walk_inside(signed(from), signed(to), frame.size[0], frame.size[1]);
    cells.map(|(_, cell)| cell).collect()
}
