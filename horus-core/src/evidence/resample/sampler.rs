use super::walk::Place;
use crate::evidence::fusion::WHOLE;
use crate::evidence::{Kernel, Lattice, MassCell, SensorGrid};

/// An evidence grid that can be asked between its cells; outside it is vacuous.
pub(crate) trait Sampler<M: MassCell> {
    /// `None`: vacuous.
    fn sample(&self, place: Place) -> Option<M>;
}

/// A grid of mass cells.
pub(crate) struct CellSampler<'a, M> {
    pub cells: &'a [M],
    pub lattice: &'a Lattice,
}

impl<M: MassCell> Sampler<M> for CellSampler<'_, M> {
    fn sample(&self, place: Place) -> Option<M> {
        let cell = |row: i32, col: i32| {
            // A negative coordinate becomes too large.
            let index = self.lattice.index(row as u32, col as u32);
            index.and_then(|i| self.cells.get(i)).copied().unwrap_or_default()
        };
        let Place { row, col, .. } = place;
        let (next_row, next_col) = (row.wrapping_add(1), col.wrapping_add(1));
        if place.is_center() {
            return Some(cell(row, col));
        }
        let corners = [
            cell(row, col),
            cell(next_row, col),
            cell(row, next_col),
            cell(next_row, next_col),
        ];
        Some(M::interpolate(corners, place.weights()))
    }
}

/// The classes of a sensor's last scan.
pub(crate) struct ClassSampler<'a, M: Kernel> {
    grid: &'a SensorGrid<'a>,
    blend: M::Blend,
    whole: [M; 2],
}

impl<'a, M: MassCell> ClassSampler<'a, M> {
    pub(crate) fn new(grid: &'a SensorGrid<'a>) -> Self {
        let model = grid.model();
        Self {
            grid,
            blend: M::blend(model.m_free, model.m_occ),
            whole: [model.m_free, model.m_occ].map(M::from_masses),
        }
    }

    /// The mean of four classes that differ.
    #[inline(never)]
    fn mixed(&self, quad: u8, place: Place) -> M {
        let (mut free, mut occupied) = (0u32, 0u32);
        for (i, weight) in place.weights().into_iter().enumerate() {
            match (quad >> (2 * i)) & 3 {
                1 => free = free.wrapping_add(weight),
                2 => occupied = occupied.wrapping_add(weight),
                _ => {}
            }
        }
        debug_assert!(free <= WHOLE && occupied <= WHOLE);
        M::mix(&self.blend, free, occupied)
    }
}

/// Four cells of the same class, by class.
const VACUOUS: u8 = 0;
const FREE: u8 = 0b0101_0101;
const OCCUPIED: u8 = 0b1010_1010;

impl<M: MassCell> Sampler<M> for ClassSampler<'_, M> {
    #[inline(always)]
    fn sample(&self, place: Place) -> Option<M> {
        match self.grid.quad(place.row, place.col) {
            VACUOUS => None,
            FREE => Some(self.whole[0]),
            OCCUPIED => Some(self.whole[1]),
            quad => Some(self.mixed(quad, place)),
        }
    }
}
