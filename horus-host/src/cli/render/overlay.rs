use horus_host::log::LogMessage;
use horus_host::log::msg::{LaserScan, Message};
use horus_host::picture::{Picture, Rgb};
use horus_host::tf::TfBuffer;

use super::GridPicture;

/// Colours of the robot and of the ends of beams, and the robot's radius in metres.
const ROBOT: Rgb = Rgb([0, 0xa0, 0x40]);
const BEAM: Rgb = Rgb([0xe0, 0x40, 0x00]);
const RADIUS: f64 = 0.15;

/// Scan and robot at the time of a grid.
pub struct Overlay<'a> {
    tf: &'a TfBuffer,
    scan_topic: &'a str,
    base: &'a str,
    /// The last scan that was logged.
    scan: Option<LaserScan>,
}

impl<'a> Overlay<'a> {
    pub fn new(tf: &'a TfBuffer, scan_topic: &'a str, base: &'a str) -> Self {
        Self {
            tf,
            scan_topic,
            base,
            scan: None,
        }
    }

    /// Takes notice of a message.
    pub fn note(&mut self, message: &LogMessage) -> anyhow::Result<()> {
        if message.topic() == self.scan_topic && message.channel.type_name == LaserScan::TYPE {
            self.scan = Some(message.decode()?);
        }
        Ok(())
    }

    /// Draws what the transforms can place in the grid's frame; nothing else.
    pub fn draw(&self, grid: &GridPicture, picture: &mut Picture) {
        if let Some(scan) = &self.scan
            && let Some(stamp_ns) = scan.header.stamp.to_ns()
            && let Ok(sensor) = self.tf.lookup(&grid.frame_id, &scan.header.frame_id, stamp_ns)
        {
            for (i, &range) in scan.ranges.iter().enumerate() {
                if !(range >= scan.range_min && range < scan.range_max) {
                    continue;
                }
                let angle =
                    f64::from(scan.angle_min) + i as f64 * f64::from(scan.angle_increment) + sensor.yaw;
                let (sin, cos) = libm::sincos(angle);
                let range = f64::from(range);
                let (gx, gy) = grid.cells_of(sensor.x + range * cos, sensor.y + range * sin);
                picture.mark_point(gx, gy, 1, BEAM);
            }
        }
        if let Ok(robot) = self.tf.lookup(&grid.frame_id, self.base, grid.stamp_ns) {
            let (gx, gy) = grid.cells_of(robot.x, robot.y);
            picture.mark_robot(
                gx,
                gy,
                robot.yaw - grid.corner.yaw,
                RADIUS / grid.resolution,
                ROBOT,
            );
        }
    }
}
