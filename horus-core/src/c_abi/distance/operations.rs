use core::ffi::c_void;

use crate::c_abi::grid::Grid;
use crate::distance::{DistanceCell, DistanceMap, DistanceOptions};
use crate::error::Error;
use crate::geometry::CellRect;

/// A distance map with the type of its cells erased.
pub(super) trait Operations {
    fn begin(&mut self, grid: &Grid, window: Option<CellRect>, options: DistanceOptions)
    -> Result<(), Error>;
    fn advance(&mut self, rows: u32) -> u32;
    fn window(&self) -> CellRect;
    fn squared_at(&self, gx: u32, gy: u32) -> Option<i64>;
    fn metres_at(&self, gx: u32, gy: u32) -> Option<f32>;
    fn nearest_obstacle(&self, grid: &Grid, gx: u32, gy: u32) -> Option<(u32, u32)>;
    fn data(&self) -> (*const c_void, usize);
}

impl<D: DistanceCell> Operations for DistanceMap<'_, D> {
    fn begin(
        &mut self,
        grid: &Grid,
        window: Option<CellRect>,
        options: DistanceOptions,
    ) -> Result<(), Error> {
        match window {
            Some(window) => self.begin_window(grid, window, options),
            None => DistanceMap::begin(self, grid, options),
        }
    }

    fn advance(&mut self, rows: u32) -> u32 {
        DistanceMap::advance(self, rows)
    }

    fn window(&self) -> CellRect {
        DistanceMap::window(self)
    }

    fn squared_at(&self, gx: u32, gy: u32) -> Option<i64> {
        let cell = DistanceMap::squared_at(self, gx, gy)?;
        let squared = i64::from(cell.squared());
        Some(if D::SIGNED && cell.is_obstacle() {
            -squared
        } else {
            squared
        })
    }

    fn metres_at(&self, gx: u32, gy: u32) -> Option<f32> {
        DistanceMap::metres_at(self, gx, gy)
    }

    fn nearest_obstacle(&self, grid: &Grid, gx: u32, gy: u32) -> Option<(u32, u32)> {
        DistanceMap::nearest_obstacle(self, grid, gx, gy)
    }

    fn data(&self) -> (*const c_void, usize) {
        let squared = self.squared();
        (squared.as_ptr().cast(), squared.len())
    }
}
