use super::{Tie, sign};

/// The part of a walk that lies inside a grid, ready to step through by linear index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct GridWalk {
    /// Linear index of the first cell.
    pub index: usize,
    /// Cells in the walk.
    pub cells: u32,
    /// Index change of a dominant step.
    major: isize,
    /// Index change of a minor step.
    minor: isize,
    err: u32,
    n: u32,
    m: u32,
}

/// Which cells of a walk are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum End {
    Included,
    Excluded,
}

impl GridWalk {
    /// The cells of the walk from `from` to `to` that lie inside a `width` x `height` grid. What lies outside is
    /// skipped in closed form: no step is ever taken there.
    ///
    /// Coordinates lie within +-2^30 and sizes are at most 2^30. Constant time.
    pub(crate) fn new(
        from: (i32, i32),
        to: (i32, i32),
        tie: Tie,
        end: End,
        (width, height): (u32, u32),
    ) -> Option<Self> {
        let (ax, ay) = (to.0.abs_diff(from.0), to.1.abs_diff(from.1));
        let (sign_x, sign_y) = (sign(from.0, to.0), sign(from.1, to.1));
        let (step_x, step_y) = (sign_x as isize, sign_y as isize * width as isize);
        let x_dominant = ax >= ay;
        let (n, m, major, minor) = if x_dominant {
            (ax, ay, step_x, step_y)
        } else {
            (ay, ax, step_y, step_x)
        };
        let last = match end {
            End::Included => n,
            End::Excluded => n.checked_sub(1)?,
        };
        let start = tie.start(n);
        let inside = |c: (i32, i32)| (c.0 as u32) < width && (c.1 as u32) < height;
        if inside(from) && inside(to) {
            let index = from.1 as usize * width as usize + from.0 as usize;
            return Some(Self {
                index,
                cells: last + 1,
                major,
                minor,
                err: start,
                n,
                m,
            });
        }
        let axis_x = Axis {
            start: from.0,
            sign: sign_x,
            size: width,
        };
        let axis_y = Axis {
            start: from.1,
            sign: sign_y,
            size: height,
        };
        let (dominant, other) = if x_dominant {
            (axis_x, axis_y)
        } else {
            (axis_y, axis_x)
        };
        let (first, last) = clip(dominant, other, (n, m, start), last)?;
        let travelled = u64::from(start) + u64::from(first) * u64::from(m);
        let (steps_minor, err) = divide(travelled, n);
        let x0y0 = |along_x: i64, along_y: i64| {
            let x = i64::from(from.0) + i64::from(sign_x) * along_x;
            let y = i64::from(from.1) + i64::from(sign_y) * along_y;
            y as usize * width as usize + x as usize
        };
        let (i, j) = (i64::from(first), steps_minor as i64);
        let index = if x_dominant { x0y0(i, j) } else { x0y0(j, i) };
        Some(Self {
            index,
            cells: last - first + 1,
            major,
            minor,
            err,
            n,
            m,
        })
    }

    /// Calls `visit` with the linear index of every cell, in order.
    #[inline(always)]
    pub(crate) fn for_each(self, mut visit: impl FnMut(usize)) {
        self.find(|index| {
            visit(index);
            false
        });
    }

    /// The linear index of the first cell for which `found` is true.
    #[inline(always)]
    pub(crate) fn find(self, mut found: impl FnMut(usize) -> bool) -> Option<usize> {
        let Self {
            mut index,
            mut cells,
            major,
            minor,
            mut err,
            n,
            m,
        } = self;
        loop {
            if found(index) {
                return Some(index);
            }
            cells -= 1;
            if cells == 0 {
                return None;
            }
            index = index.wrapping_add_signed(major);
            err += m;
            if err >= n {
                index = index.wrapping_add_signed(minor);
                err -= n;
            }
        }
    }
}

/// One axis of a walk: where it starts, which way it goes, and the grid's size along it.
#[derive(Clone, Copy)]
struct Axis {
    start: i32,
    sign: i32,
    size: u32,
}

impl Axis {
    /// The distances from the start, in the direction of travel, that lie inside: first to last.
    fn inside(self) -> Option<(i64, i64)> {
        let (start, size) = (i64::from(self.start), i64::from(self.size));
        let (near, far) = if self.sign < 0 {
            (start - (size - 1), start)
        } else {
            (-start, size - 1 - start)
        };
        (size > 0 && far >= 0).then_some((near.max(0), far))
    }
}

/// First and last step `i <= last` whose cell lies inside on both axes.
fn clip(dominant: Axis, other: Axis, (n, m, start): (u32, u32, u32), last: u32) -> Option<(u32, u32)> {
    let (mut first, far) = dominant.inside()?;
    let mut last = far.min(i64::from(last));
    let (q0, q1) = other.inside()?;
    if m == 0 {
        if q0 > 0 {
            return None;
        }
    } else {
        // The minor coordinate has moved q cells for steps ceil((q n - start) / m) and on.
        let reaches = |q: i64| {
            let ahead = q as u64 * u64::from(n) - u64::from(start); // q is not 0
            divide(ahead + u64::from(m) - 1, m).0 as i64
        };
        if q0 > 0 {
            first = first.max(reaches(q0));
        }
        last = last.min(reaches(q1 + 1) - 1);
    }
    (first <= last).then_some((first as u32, last as u32))
}

/// Quotient and remainder; both 0 for a divisor of 0. The divisor is at most 2^31.
///
/// Dividends fit 32 bits unless an end lies far outside: the compiler's 64-bit division would take a
/// kilobyte of flash for those.
#[inline(never)]
fn divide(dividend: u64, divisor: u32) -> (u64, u32) {
    if divisor == 0 {
        return (0, 0);
    }
    if let Ok(dividend) = u32::try_from(dividend) {
        return (u64::from(dividend / divisor), dividend % divisor);
    }
    let (mut quotient, mut remainder) = (dividend, 0);
    for _ in 0..u64::BITS {
        remainder = remainder << 1 | (quotient >> 63) as u32;
        quotient <<= 1;
        if remainder >= divisor {
            remainder -= divisor;
            quotient |= 1;
        }
    }
    (quotient, remainder)
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use std::vec::Vec;

    /// The rule as SPEC 4 words it, stepping through every cell.
    fn stepped(from: (i32, i32), to: (i32, i32), tie: Tie) -> Vec<(i32, i32)> {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let (mut x, mut y) = from;
        let mut cells = std::vec![(x, y)];
        let x_dominant = dx.abs() >= dy.abs();
        let (da, db) = if x_dominant {
            (dx.abs(), dy.abs())
        } else {
            (dy.abs(), dx.abs())
        };
        // Beluga's error term is twice navground's.
        let (mut err, scale) = match tie {
            Tie::Near => (da, 2),
            Tie::Far => (da / 2, 1),
        };
        for _ in 0..da {
            err += scale * db;
            let minor = match tie {
                Tie::Near => err > scale * da,
                Tie::Far => err >= da,
            };
            if minor {
                err -= scale * da;
            }
            if x_dominant || minor {
                x += dx.signum();
            }
            if !x_dominant || minor {
                y += dy.signum();
            }
            cells.push((x, y));
        }
        cells
    }

    #[test]
    fn clipped_walks_equal_filtered_steps() {
        for (w, h) in [(1u32, 1u32), (1, 5), (7, 4), (5, 5)] {
            let range = -6i32..=9;
            for fx in range.clone() {
                for fy in range.clone() {
                    for tx in range.clone() {
                        for ty in range.clone() {
                            let ends = [End::Included, End::Excluded];
                            for (end, tie) in ends.into_iter().flat_map(|e| [(e, Tie::Near), (e, Tie::Far)]) {
                                let mut expected = stepped((fx, fy), (tx, ty), tie);
                                if end == End::Excluded {
                                    expected.pop();
                                }
                                let expected: Vec<usize> = expected
                                    .into_iter()
                                    .filter(|c| (c.0 as u32) < w && (c.1 as u32) < h)
                                    .map(|c| c.1 as usize * w as usize + c.0 as usize)
                                    .collect();
                                let mut got = Vec::new();
                                if let Some(walk) = GridWalk::new((fx, fy), (tx, ty), tie, end, (w, h)) {
                                    walk.for_each(|i| got.push(i));
                                }
                                assert_eq!(got, expected, "({fx},{fy}) ({tx},{ty}) {w}x{h} {tie:?} {end:?}");
                            }
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn division_equals_the_compilers() {
        for dividend in [
            0,
            1,
            7,
            u64::from(u32::MAX),
            1 << 32,
            (1 << 33) + 5,
            (1 << 62) - 1,
            u64::MAX,
        ] {
            for divisor in [1, 2, 3, 1000, 0xffff, (1 << 30) + 1, (1 << 31) - 1, 1 << 31] {
                let wide = u64::from(divisor);
                let expected = (dividend / wide, (dividend % wide) as u32);
                assert_eq!(divide(dividend, divisor), expected, "{dividend} / {divisor}");
            }
        }
        assert_eq!(divide(5, 0), (0, 0));
    }

    #[test]
    fn far_ends_do_not_overflow() {
        let limit = 1 << 30;
        let far = [-limit, -limit + 1, -1, 0, 3, limit - 1, limit];
        let mut seen = 0;
        for fx in far {
            for fy in far {
                for tx in far {
                    for ty in far {
                        let walk = GridWalk::new((fx, fy), (tx, ty), Tie::Far, End::Included, (4, 4));
                        if let Some(walk) = walk {
                            assert!(walk.cells <= 4, "{walk:?}");
                            walk.for_each(|i| assert!(i < 16));
                            seen += 1;
                        }
                    }
                }
            }
        }
        assert!(seen > 10, "{seen} walks crossed the grid");
    }

    #[test]
    fn an_empty_grid_has_no_cells() {
        assert_eq!(
            GridWalk::new((0, 0), (0, 0), Tie::Far, End::Included, (0, 0)),
            None
        );
        assert_eq!(
            GridWalk::new((-3, 0), (5, 0), Tie::Far, End::Included, (0, 7)),
            None
        );
    }
}
