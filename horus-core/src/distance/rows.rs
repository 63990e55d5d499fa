//! From distances within columns to distances: row by row.

use super::envelope::{self, EnvelopeVertex};
use super::lanes::{BLOCK, LOOK, Lanes};
use super::{DistanceCell, MAX_SIDE};

/// Whether this core is quicker with [`Lanes`], where they will do. `--cfg horus_bits_kernel` tests the other kernel
/// on a host.
const PREFER_LANES: bool = cfg!(all(target_pointer_width = "64", not(horus_bits_kernel)));

/// What a distance reads at most: the cap.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cap(pub u32);

impl Cap {
    /// The farthest that an obstacle can lie away along an axis and matter.
    pub(super) fn reach(self) -> u32 {
        self.0.saturating_sub(1).isqrt().min(MAX_SIDE)
    }
}

/// Where a row of a map lies while it is computed, and where it goes: never behind where it was.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// First cell, and cells, with the columns to the left and right of the window.
    pub from: usize,
    pub width: u32,
    /// Columns left of the window.
    pub left: u32,
    /// First cell, and cells, within the window.
    pub to: usize,
    pub window: u32,
}

/// Turns one row after the other from distances within columns into squared distances.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rows {
    cap: Cap,
    /// The largest squared distance in the row before.
    farthest: u32,
}

impl Rows {
    pub(super) fn new(cap: Cap) -> Self {
        Self {
            cap,
            farthest: u32::MAX,
        }
    }

    pub(super) fn lower<D: DistanceCell>(
        &mut self,
        cells: &mut [D],
        vertices: &mut [EnvelopeVertex],
        place: Place,
    ) {
        let reach = self.cap.reach();
        let near = self.farthest.min(reach.saturating_mul(reach)) <= (LOOK * LOOK) as u32;
        if PREFER_LANES && near {
            self.by_lanes(cells, place);
        } else {
            self.by_envelope(cells, vertices, place);
        }
        if PREFER_LANES {
            let row = cells
                .get(place.to..place.to + place.window as usize)
                .unwrap_or_default();
            self.farthest = row.iter().fold(0, |farthest, cell| farthest.max(cell.squared()));
        }
    }

    fn by_lanes<D: DistanceCell>(&self, cells: &mut [D], place: Place) {
        let reach = self.cap.reach();
        let (left, window, width) = (place.left as usize, place.window as usize, place.width as usize);
        let row = cells.get(place.from..place.from + width).unwrap_or_default();
        let mut outside = Lanes::before(row, left, reach, from_clear::<D>);
        let mut inside = D::SIGNED.then(|| Lanes::before(row, left, reach, from_obstacle::<D>));
        for start in (0..window).step_by(BLOCK) {
            let used = BLOCK.min(window - start);
            let ahead = (left + start + LOOK).min(width);
            let ahead = place.from + ahead..place.from + (ahead + BLOCK).min(width);
            let ahead = cells.get(ahead).unwrap_or_default();
            outside.slide(ahead, from_clear);
            let squared = outside.squared(used).into_iter();
            let Some(inside) = &mut inside else {
                let block = cells.iter_mut().skip(place.to + start).take(used);
                block
                    .zip(squared)
                    .for_each(|(cell, s)| *cell = D::new(false, self.capped(s)));
                continue;
            };
            inside.slide(ahead, from_obstacle);
            // An obstacle is no distance away from one, and far from what is none.
            let both = squared.zip(inside.squared(used));
            let block = cells.iter_mut().skip(place.to + start).take(used);
            block
                .zip(both)
                .for_each(|(cell, (out, inn))| *cell = D::new(out == 0, self.capped(out.max(inn))));
        }
    }

    fn capped(&self, squared: i16) -> u32 {
        u32::from(squared.unsigned_abs()).min(self.cap.0)
    }

    fn by_envelope<D: DistanceCell>(&self, cells: &mut [D], vertices: &mut [EnvelopeVertex], place: Place) {
        let (reach, cap) = (self.cap.reach(), self.cap.0);
        let Place {
            from,
            width,
            left,
            to,
            window,
        } = place;
        let row = cells.get(from..from + width as usize).unwrap_or_default().iter();
        if !D::SIGNED {
            let envelope = envelope::build(vertices, row.map(|d| from_clear(*d)), width, reach);
            let target = cells.get_mut(to..to + window as usize).unwrap_or_default();
            return envelope.write(left, target, cap);
        }
        let Some((outside, inside)) = vertices.split_at_mut_checked(width as usize) else {
            return;
        };
        let mut outside = envelope::build(outside, row.clone().map(|d| from_clear(*d)), width, reach);
        let mut inside = envelope::build(inside, row.map(|d| from_obstacle(*d)), width, reach);
        for (x, column) in (0..window as usize).zip(left..) {
            let Some(obstacle) = cells.get(from + column as usize).map(|d| d.is_obstacle()) else {
                return;
            };
            let envelope = if obstacle { &mut inside } else { &mut outside };
            if let Some(cell) = cells.get_mut(to + x) {
                *cell = D::new(obstacle, envelope.next(column, cap));
            }
        }
    }
}

/// Distance to the nearest obstacle.
#[inline(always)]
fn from_clear<D: DistanceCell>(cell: D) -> u32 {
    if cell.is_obstacle() { 0 } else { cell.squared() }
}

/// Distance to the nearest cell that is no obstacle.
#[inline(always)]
fn from_obstacle<D: DistanceCell>(cell: D) -> u32 {
    if cell.is_obstacle() { cell.squared() } else { 0 }
}
