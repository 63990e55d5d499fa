use core::str::FromStr;

use super::FREE;
use super::frame::Frame;
use crate::error::Error;
use crate::geometry::Pose2D;
use crate::math;

/// The area around the robot's centre that an update makes free.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Footprint {
    /// A square with sides of twice the radius, along the map's axes.
    #[default]
    Rectangular,
    /// A disc of the radius.
    Circular,
    /// Nothing.
    None,
}

impl Footprint {
    /// Its name in navground's configuration files.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Rectangular => "rectangular",
            Self::Circular => "circular",
            Self::None => "none",
        }
    }

    /// Frees the cells of a footprint of `radius` metres around a pose; cut at the map's border.
    pub(super) fn clear(self, cells: &mut [u8], frame: &Frame, pose: Pose2D, radius: f32) {
        match self {
            Self::Rectangular => clear_square(cells, frame, pose, radius),
            Self::Circular => clear_disc(cells, frame, pose, radius),
            Self::None => {}
        }
    }
}

impl FromStr for Footprint {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self, Error> {
        [Self::Rectangular, Self::Circular, Self::None]
            .into_iter()
            .find(|footprint| footprint.as_str() == name)
            .ok_or(Error::UnknownFootprint)
    }
}

/// From the cell of one corner up to, not including, that of the other.
fn clear_square(cells: &mut [u8], frame: &Frame, pose: Pose2D, radius: f32) {
    let span = |p: f32, axis: usize| {
        let low = p - radius;
        frame.clamped(low, axis)..frame.clamped(low + 2.0 * radius, axis)
    };
    let (columns, rows) = (span(pose.x, 0), span(pose.y, 1));
    for gy in rows {
        frame.row_mut(cells, gy, columns.clone()).fill(FREE);
    }
}

/// Rows of the disc, each as wide as the circle is there, rounded to whole cells.
fn clear_disc(cells: &mut [u8], frame: &Frame, pose: Pose2D, radius: f32) {
    let Some((cx, cy)) = frame.cell(pose.x, pose.y) else {
        return;
    };
    let q = radius / frame.resolution;
    let reach = i64::from(math::ceil(q) as i32); // saturates
    let (cx, cy) = (i64::from(cx), i64::from(cy));
    let [width, height] = frame.size.map(i64::from);
    for i in (-reach).max(-cy)..=reach.min(height - 1 - cy) {
        let offset = i as f32;
        let half = math::sqrt((q * q - offset * offset).max(0.0));
        let j = i64::from(math::round(half) as i32); // saturates
        if j == 0 && i != 0 {
            continue;
        }
        let columns = (cx - j).max(0) as u32..(cx + j + 1).min(width) as u32;
        frame.row_mut(cells, (cy + i) as u32, columns).fill(FREE);
    }
}
