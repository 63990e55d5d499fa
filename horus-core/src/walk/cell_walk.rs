use core::iter::FusedIterator;

use nalgebra::Vector2;

use super::{WalkRule, sign};

/// The cells of a straight walk between two cells, both ends included.
///
/// Any two cells of the range of `i32`; no cell outside the rectangle they span is visited. Source:
/// Beluga `bresenham.hpp`, navground and nav2 `raytrace` (see [`WalkRule`]).
///
/// # Complexity
/// Constant time per cell: `max(|dx|, |dy|) + 1` cells, for a supercover at most
/// `|dx| + |dy| + min(|dx|, |dy|) + 1`.
///
/// # Examples
/// ```
/// use horus_core::nalgebra::Vector2;
/// use horus_core::raycast::{CellWalk, WalkRule};
///
/// let cells = |rule| CellWalk::new(Vector2::new(0, 0), Vector2::new(2, 1), rule).map(|c| (c.x, c.y));
/// assert!(cells(WalkRule::Standard).eq([(0, 0), (1, 0), (2, 1)]));
/// assert!(cells(WalkRule::Navground).eq([(0, 0), (1, 1), (2, 1)]));
/// assert!(cells(WalkRule::Supercover).eq([(0, 0), (1, 0), (1, 1), (2, 1)]));
/// ```
#[derive(Clone, Debug)]
pub struct CellWalk {
    cell: Vector2<i32>,
    /// Change of a step along the dominant axis, and along the other.
    major: Vector2<i32>,
    minor: Vector2<i32>,
    /// Steps that are left.
    steps: u32,
    /// Twice the cells along either axis, and twice the error term, so that halves are exact.
    n2: u64,
    m2: u64,
    err: u64,
    supercover: bool,
    /// Cells that a supercover passes before it reaches `cell`.
    passed: [Option<Vector2<i32>>; 2],
    /// `cell` is still to be handed out.
    arrived: bool,
}

impl CellWalk {
    /// The walk from one cell to another.
    pub fn new(from: Vector2<i32>, to: Vector2<i32>, rule: WalkRule) -> Self {
        let (ax, ay) = (to.x.abs_diff(from.x), to.y.abs_diff(from.y));
        let along_x = Vector2::new(sign(from.x, to.x), 0);
        let along_y = Vector2::new(0, sign(from.y, to.y));
        let (n, m, major, minor) = if ax >= ay {
            (ax, ay, along_x, along_y)
        } else {
            (ay, ax, along_y, along_x)
        };
        let err = match rule {
            WalkRule::Standard | WalkRule::Supercover => u64::from(n),
            // One more than the even number it stands for: a tie is above the limit.
            WalkRule::Navground => u64::from(n | 1),
        };
        Self {
            cell: from,
            major,
            minor,
            steps: n,
            n2: 2 * u64::from(n),
            m2: 2 * u64::from(m),
            err,
            supercover: rule == WalkRule::Supercover,
            passed: [None; 2],
            arrived: true,
        }
    }

    fn step(&mut self) {
        // Between two cells of the range: no sum leaves it.
        let plus = |a: Vector2<i32>, b: Vector2<i32>| a.zip_map(&b, i32::wrapping_add);
        let (before, start) = (self.err, self.cell);
        self.steps -= 1;
        self.err += self.m2;
        self.cell = plus(start, self.major);
        if self.err > self.n2 {
            self.err -= self.n2;
            let across = self.cell;
            self.cell = plus(across, self.minor);
            if self.supercover {
                let sum = before + self.err;
                self.passed = [
                    (sum <= self.n2).then_some(across),
                    (sum >= self.n2).then(|| plus(start, self.minor)),
                ];
            }
        }
        self.arrived = true;
    }
}

impl Iterator for CellWalk {
    type Item = Vector2<i32>;

    #[inline]
    fn next(&mut self) -> Option<Vector2<i32>> {
        if !self.arrived {
            if self.steps == 0 {
                return None;
            }
            self.step();
        }
        if self.supercover {
            let passed = self.passed.iter_mut().find_map(Option::take);
            if passed.is_some() {
                return passed;
            }
        }
        self.arrived = false;
        Some(self.cell)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let steps = self.steps as usize;
        let least = steps.saturating_add(self.arrived.into());
        let most = if self.supercover {
            steps.checked_mul(3).and_then(|cells| cells.checked_add(3))
        } else {
            Some(least)
        };
        (least, most)
    }
}

impl FusedIterator for CellWalk {}
