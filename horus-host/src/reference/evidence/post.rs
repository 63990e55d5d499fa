use super::Masses;

/// A rectangle given masses; see the core's type of that name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inpaint {
    /// Whether the rectangle moves with the robot, or stays in the world.
    pub with_robot: bool,
    /// First and last x, metres.
    pub x: [f32; 2],
    /// First and last y, metres.
    pub y: [f32; 2],
    /// What its cells hold.
    pub masses: Masses,
}

impl Inpaint {
    /// Whether it holds a cell centre in the world, while the robot stands at x, y (metres) with a heading (radians):
    /// f32, in this order.
    pub(super) fn holds(&self, center: [f32; 2], robot: [f32; 3]) -> bool {
        let [mut x, mut y] = center;
        if self.with_robot {
            let (c, s) = (libm::cosf(robot[2]), libm::sinf(robot[2]));
            let (dx, dy) = (x - robot[0], y - robot[1]);
            (x, y) = (c * dx + s * dy, c * dy - s * dx);
        }
        self.x[0] <= x && x <= self.x[1] && self.y[0] <= y && y <= self.y[1]
    }
}

/// What is occupied; see the core's type of that name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BinaryThresholds {
    /// Least mass free of a free cell.
    pub free_threshold: f64,
    /// Least mass occupied of an occupied cell.
    pub occupied_threshold: f64,
    /// Whether other cells are free.
    pub is_optimistic: bool,
}

/// Whether each cell is occupied.
pub fn evidence_to_binary(cells: &[Masses], thresholds: &BinaryThresholds) -> Vec<bool> {
    let is_occupied = |m: &Masses| {
        if m.occupied >= thresholds.occupied_threshold {
            true
        } else if m.free >= thresholds.free_threshold {
            false
        } else {
            !thresholds.is_optimistic
        }
    };
    cells.iter().map(is_occupied).collect()
}
