//! A cost map that follows a local map.

use super::map::occupancy_of;
use super::{FREE, LocalGridMap, OCCUPIED, UNKNOWN};
use crate::costmap::{CostMap, FieldCell};
use crate::error::Error;
use crate::geometry::GridInfo;
use crate::grid;

impl<S: AsRef<[u8]>> LocalGridMap<'_, S> {
    /// Makes a cost map show this map: its window moves by whole cells to where this one lies, then
    /// the cells that differ are set (occupied 100, unknown -1, free 0), and no others: a cell that
    /// was cleared and marked again since the last call is not touched. The costs follow with the
    /// cost map's next update.
    ///
    /// The cost map must have this map's size and resolution, and its grid must have been made with
    /// its corner at the origin. It takes no further memory, and it does not matter what happened
    /// between two calls.
    ///
    /// # Errors
    /// [`Error::GeometryMismatch`]; nothing changes then.
    ///
    /// # Complexity
    /// One read per cell of each map; one write per cell that differs; if the window moved, one read
    /// and one write per cell and layer of the cost map.
    pub fn update_cost_map<F: FieldCell>(&self, map: &mut CostMap<'_, F>) -> Result<(), Error> {
        follow(self.info(), self.data(), map)
    }
}

/// What can follow a local map.
pub(crate) trait Follower {
    fn info(&self) -> &GridInfo;
    fn cells(&self) -> &[i8];
    fn move_to(&mut self, offset: [i32; 2]);
    fn set_occupancy(&mut self, gx: u32, gy: u32, value: i8);
}

impl<F: FieldCell> Follower for CostMap<'_, F> {
    fn info(&self) -> &GridInfo {
        CostMap::info(self)
    }

    fn cells(&self) -> &[i8] {
        self.occupancy_grid().data()
    }

    fn move_to(&mut self, offset: [i32; 2]) {
        CostMap::move_to(self, offset);
    }

    fn set_occupancy(&mut self, gx: u32, gy: u32, value: i8) {
        CostMap::set_occupancy(self, gx, gy, value);
    }
}

/// [`LocalGridMap::update_cost_map`].
pub(crate) fn follow<M: Follower + ?Sized>(own: &GridInfo, cells: &[u8], map: &mut M) -> Result<(), Error> {
    let its = map.info();
    let same = own.width() == its.width()
        && own.height() == its.height()
        && own.resolution() == its.resolution()
        && own.first_origin() == its.first_origin();
    if !same {
        return Err(Error::GeometryMismatch);
    }
    map.move_to(own.offset());
    let width = own.width() as usize;
    if width == 0 {
        return Ok(());
    }
    for (gy, values) in (0..).zip(cells.chunks_exact(width)) {
        follow_row(map, gy, values);
    }
    Ok(())
}

/// Sets the cells of a row that differ.
fn follow_row<M: Follower + ?Sized>(map: &mut M, gy: u32, values: &[u8]) {
    let start = gy as usize * values.len();
    let mut gx = 0;
    let mut rest = values;
    while let Some((four, after)) = rest.split_first_chunk::<4>() {
        let at = start + gx as usize;
        let present = map.cells().get(at..at + 4).and_then(<[i8]>::first_chunk::<4>);
        if present.map(|present| present.map(|cell| cell as u8)) != Some(occupancies_of(*four)) {
            set_different(map, gx, gy, four);
        }
        gx += 4;
        rest = after;
    }
    set_different(map, gx, gy, rest);
}

fn set_different<M: Follower + ?Sized>(map: &mut M, gx: u32, gy: u32, values: &[u8]) {
    for (gx, value) in (gx..).zip(values) {
        map.set_occupancy(gx, gy, occupancy_of(*value));
    }
}

/// Four cells in the terms of occupancy grids, read as bytes, in one go: with the highest and the
/// lowest bit of each, unknown is 1 0, free 1 1 and occupied 0 0.
fn occupancies_of(values: [u8; 4]) -> [u8; 4] {
    const ONES: u32 = 0x0101_0101;
    const _: () = assert!(OCCUPIED == 0 && UNKNOWN == 0x80 && FREE == 0xff);
    let word = u32::from_ne_bytes(values);
    let (high, low) = (word >> 7 & ONES, word & ONES);
    let (occupied, unknown) = (high ^ ONES, high & !low);
    // One factor per byte, and at most one of both is set: no carry.
    (occupied * grid::OCCUPIED as u32 | unknown * 0xff).to_ne_bytes()
}

#[cfg(test)]
mod tests {
    use super::{FREE, OCCUPIED, UNKNOWN, occupancies_of, occupancy_of};

    #[test]
    fn four_cells_at_once_equal_one_by_one() {
        let values = [OCCUPIED, UNKNOWN, FREE];
        for n in 0..81usize {
            let four = [n / 27, n / 9 % 3, n / 3 % 3, n % 3].map(|i| values[i]);
            let expected = four.map(|value| occupancy_of(value) as u8);
            assert_eq!(occupancies_of(four), expected);
        }
    }
}
