//! Beluga's named requirements, answered cell by cell in f64. Points are metres in the grid's local frame, whose origin
//! is the corner of cell (0, 0), unless a name says global.

use super::OccupancyGrid;
use super::frame::BOUNDARY;

/// What the values of a grid's cells mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Values {
    /// Free 0 to 49, occupied from 50 on, unknown -1.
    Horus,
    /// Free 0, occupied 100, unknown -1; every other value is none of these.
    Trinary,
}

/// A grid read through Beluga's requirements.
#[derive(Debug, Clone, Copy)]
pub struct BelugaGrid<'a> {
    /// The grid.
    pub grid: &'a OccupancyGrid,
    /// What its values mean.
    pub values: Values,
}

impl BelugaGrid<'_> {
    /// The cell that holds a local point, inside the map or not; `None` if it is not finite or its cell is no `i32`.
    pub fn cell_near(&self, p: [f64; 2]) -> Option<[i32; 2]> {
        let cell = |x: f64| {
            let cell = (x / f64::from(self.grid.resolution) + f64::from(BOUNDARY)).floor();
            (f64::from(i32::MIN) <= cell && cell <= f64::from(i32::MAX)).then_some(cell as i32)
        };
        Some([cell(p[0])?, cell(p[1])?])
    }

    /// Local coordinates of a cell's centre, inside the map or not.
    pub fn local_coordinates_at(&self, cell: [i32; 2]) -> [f64; 2] {
        cell.map(|c| (f64::from(c) + 0.5) * f64::from(self.grid.resolution))
    }

    /// Global coordinates of a cell's centre, inside the map or not.
    pub fn global_coordinates_at(&self, cell: [i32; 2]) -> [f64; 2] {
        let [gx, gy] = cell.map(|c| f64::from(c) + 0.5);
        self.grid.corner_plus(gx, gy).into()
    }

    /// A cell's value; `None` outside.
    pub fn data_at(&self, cell: [i32; 2]) -> Option<i8> {
        let [gx, gy] = cell.map(u32::try_from);
        self.grid.occupancy(gx.ok()?, gy.ok()?)
    }

    /// Whether a cell is free; `false` where it is unknown or outside.
    pub fn free_at(&self, cell: [i32; 2]) -> bool {
        self.data_at(cell).is_some_and(|v| match self.values {
            Values::Horus => (0..50).contains(&v),
            Values::Trinary => v == 0,
        })
    }

    /// The cells inside that share a side with a cell inside: +x, +y, -x, -y.
    pub fn neighborhood4(&self, cell: [i32; 2]) -> Vec<[i32; 2]> {
        if self.data_at(cell).is_none() {
            return Vec::new();
        }
        let sides = [[1, 0], [0, 1], [-1, 0], [0, -1]];
        let cells = sides.map(|side| [cell[0] + side[0], cell[1] + side[1]]);
        let inside = cells.into_iter().filter(|c| self.data_at(*c).is_some());
        inside.collect()
    }

    /// Indices of the free cells, ascending.
    pub fn free_cells(&self) -> Vec<usize> {
        let cells = 0..self.grid.data.len();
        cells.filter(|i| self.free_at(self.cell_of(*i))).collect()
    }

    /// Which cells are occupied.
    pub fn obstacle_data(&self) -> Vec<bool> {
        let occupied = |v: &i8| match self.values {
            Values::Horus => *v >= 50,
            Values::Trinary => *v == 100,
        };
        self.grid.data.iter().map(occupied).collect()
    }

    /// Which cells are unknown.
    pub fn unknown_mask(&self) -> Vec<bool> {
        self.grid.data.iter().map(|v| *v == -1).collect()
    }

    /// Which cells are occupied and share a side with a free one.
    pub fn obstacle_edge_mask(&self) -> Vec<bool> {
        let obstacles = self.obstacle_data();
        let edge = |i: usize| {
            let neighbours = self.neighborhood4(self.cell_of(i));
            obstacles[i] && neighbours.into_iter().any(|cell| self.free_at(cell))
        };
        (0..obstacles.len()).map(edge).collect()
    }

    /// The cell with an index.
    pub fn cell_of(&self, index: usize) -> [i32; 2] {
        let width = self.grid.width as usize;
        [(index % width) as i32, (index / width) as i32]
    }
}
