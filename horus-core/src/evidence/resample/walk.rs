use super::rigid::Rigid;
use crate::evidence::fusion::WHOLE;

/// Coordinates nearer than this to a whole cell, in cells, count as whole: 1e-4 as a fraction of 2^32.
const SNAP: i64 = 429_497;

/// A coordinate of 2^32 per cell.
const ONE: f64 = 4_294_967_296.0;

/// Where the cell centres of one grid lie in another: a coordinate per axis, in cells counted from the
/// centre of the other's cell (0, 0), with 32 fractional bits. Steps are exact; only the first
/// coordinate and the two steps are rounded, to 2^-33 cells.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CellWalk {
    at: [i64; 2],
    along_x: [i64; 2],
    along_y: [i64; 2],
}

/// A place between the centres of four cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Place {
    /// The cell with the lower coordinates.
    pub row: i32,
    pub col: i32,
    /// How far towards the next row and column, as fractions of 2^32, before snapping.
    fraction: [u32; 2],
}

impl CellWalk {
    /// Both grids by their cell size and their sizes in cells; `src_from_dst` takes metres from the
    /// corner of the destination's window to metres from that of the source's. `None` if some cell is
    /// farther than 2^30 cells away, where nothing of a source can be.
    pub(crate) fn new(src_from_dst: &Rigid, dst: (f32, [u32; 2]), src_cell: f32) -> Option<Self> {
        let (dst_cell, size) = dst;
        let (dst_cell, src_cell) = (f64::from(dst_cell), f64::from(src_cell));
        let g = |cells: [f64; 2]| {
            let metres = cells.map(|c| (c + 0.5) * dst_cell);
            src_from_dst.apply(metres).map(|l| l / src_cell - 0.5)
        };
        let [width, height] = size.map(f64::from);
        for corner in [[0.0, 0.0], [width, 0.0], [0.0, height], [width, height]] {
            // Also false for NaN.
            if !g(corner).iter().all(|c| c.abs() < 1_073_741_824.0) {
                return None;
            }
        }
        let fixed = |v: f64| nearest(v * ONE);
        let first = g([0.0, 0.0]);
        let [cos, sin] = src_from_dst.direction().map(|v| v * dst_cell / src_cell);
        Some(Self {
            // The margin of snapping, so that one comparison finds both of its sides.
            at: first.map(|v| fixed(v).wrapping_add(SNAP)),
            along_x: [cos, sin].map(fixed),
            along_y: [-sin, cos].map(fixed),
        })
    }

    /// The place of the present cell; the walk goes on to the next one along x.
    #[inline(always)]
    pub(crate) fn next(&mut self) -> Place {
        let ([x, y], [dx, dy]) = (self.at, self.along_x);
        self.at = [x.wrapping_add(dx), y.wrapping_add(dy)];
        Place {
            row: (x >> 32) as i32,
            col: (y >> 32) as i32,
            fraction: [x as u32, y as u32],
        }
    }

    /// Goes on to the next line.
    pub(crate) fn next_line(&mut self) {
        let ([x, y], [dx, dy]) = (self.at, self.along_y);
        self.at = [x.wrapping_add(dx), y.wrapping_add(dy)];
    }
}

#[inline(always)]
fn snapped(fraction: u32) -> u32 {
    if fraction <= 2 * SNAP as u32 {
        0
    } else {
        fraction - SNAP as u32
    }
}

/// The nearest integer, halves away from zero, within +-2^63.
fn nearest(v: f64) -> i64 {
    (v + if v < 0.0 { -0.5 } else { 0.5 }) as i64
}

impl Place {
    /// True at the centre of the first of the four cells.
    pub(crate) fn is_center(&self) -> bool {
        self.fraction.iter().all(|f| snapped(*f) == 0)
    }

    /// Weights of the four cells: (row, col), (row + 1, col), (row, col + 1), (row + 1, col + 1).
    /// They sum to 2^31.
    #[inline]
    pub(crate) fn weights(&self) -> [u32; 4] {
        // Fractions of 2^31: the lowest bit is 1e-10 of a cell.
        let [a, b] = self.fraction.map(|f| snapped(f) >> 1);
        let both = ((u64::from(a) * u64::from(b)) >> 31) as u32;
        let (only_a, only_b) = (a - both, b - both);
        [WHOLE - both - only_a - only_b, only_a, only_b, both]
    }
}
