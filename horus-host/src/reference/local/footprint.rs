use super::frame::LocalFrame;

/// What a local map frees around the robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LocalFootprint {
    /// A square of twice the radius, along the map's axes.
    #[default]
    Rectangular,
    /// A disc of the radius.
    Circular,
    /// Nothing.
    None,
}

impl LocalFootprint {
    /// Whether a cell lies under a footprint of `radius` metres around a point.
    pub(super) fn covers(self, frame: &LocalFrame, center: [f32; 2], radius: f32, cell: [u32; 2]) -> bool {
        match self {
            Self::Rectangular => (0..2).all(|axis| {
                let low = center[axis] - radius;
                let first = frame.clamped_coordinate(low, axis);
                let end = frame.clamped_coordinate(low + 2.0 * radius, axis);
                (first..end).contains(&i64::from(cell[axis]))
            }),
            Self::Circular => {
                let Some(middle) = frame.cell(center) else {
                    return false;
                };
                let q = radius / frame.resolution;
                let row = i64::from(cell[1]) - i64::from(middle[1]);
                let column = i64::from(cell[0]) - i64::from(middle[0]);
                if row.abs() > libm::ceilf(q) as i64 {
                    return false;
                }
                let half = libm::roundf(libm::sqrtf((q * q - row as f32 * row as f32).max(0.0))) as i64;
                column.abs() <= half && (half > 0 || row == 0)
            }
            Self::None => false,
        }
    }
}
