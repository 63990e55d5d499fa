//! The subject of Beluga's vectors is the std version.

use horus_host::reference::{
    BelugaGrid, OccupancyGrid, Pose2D, Values, Walk, squared_distances as distances, standard_walk,
    supercover_walk,
};

/// How far a coordinate may be off, relative to 1 m or its own size: resolutions are 32-bit floats here.
pub const COORDINATE_ERROR: f64 = 1e-7;

pub fn standard(from: [i32; 2], to: [i32; 2]) -> Vec<[i32; 2]> {
    standard_walk(from, to)
}

pub fn supercover(from: [i32; 2], to: [i32; 2]) -> Vec<[i32; 2]> {
    supercover_walk(from, to)
}

/// The distances by every way to compute them.
pub fn squared_distances(mask: &[bool], width: u32, cap: u32) -> Vec<Vec<u32>> {
    vec![distances(mask, width as usize, cap)]
}

pub struct Map(OccupancyGrid);

impl Map {
    pub fn new(width: u32, height: u32, resolution: f32, [x, y, theta]: [f64; 3], cells: Vec<i8>) -> Self {
        let mut grid = OccupancyGrid::new(width, height, resolution, Pose2D::new(x, y, theta));
        assert_eq!(grid.data.len(), cells.len());
        grid.data = cells;
        Self(grid)
    }

    fn beluga(&self) -> BelugaGrid<'_> {
        BelugaGrid {
            grid: &self.0,
            values: Values::Trinary,
        }
    }

    pub fn cell_of(&self, index: usize) -> [i32; 2] {
        self.beluga().cell_of(index)
    }

    fn inside(&self, index: usize) -> Option<[i32; 2]> {
        (index < self.0.data.len()).then(|| self.cell_of(index))
    }

    pub fn cell_near(&self, p: [f64; 2]) -> Option<[i32; 2]> {
        self.beluga().cell_near(p)
    }

    pub fn local_coordinates_at(&self, cell: [i32; 2]) -> [f64; 2] {
        self.beluga().local_coordinates_at(cell)
    }

    pub fn local_coordinates_of(&self, index: usize) -> [f64; 2] {
        self.local_coordinates_at(self.cell_of(index))
    }

    pub fn global_coordinates_of(&self, index: usize) -> [f64; 2] {
        self.beluga().global_coordinates_at(self.cell_of(index))
    }

    pub fn global_coordinates_for_free_cells(&self) -> Vec<[f64; 2]> {
        let cells = self.free_cells().into_iter();
        cells.map(|i| self.global_coordinates_of(i)).collect()
    }

    pub fn data_at(&self, cell: [i32; 2]) -> Option<i8> {
        self.beluga().data_at(cell)
    }

    pub fn data_at_index(&self, index: usize) -> Option<i8> {
        self.data_at(self.inside(index)?)
    }

    pub fn data_near(&self, p: [f64; 2]) -> Option<i8> {
        self.data_at(self.cell_near(p)?)
    }

    pub fn index_at(&self, cell: [i32; 2]) -> Option<usize> {
        (0..self.0.data.len()).find(|i| self.cell_of(*i) == cell)
    }

    pub fn free_at(&self, cell: [i32; 2]) -> bool {
        self.beluga().free_at(cell)
    }

    pub fn free_at_index(&self, index: usize) -> bool {
        self.inside(index).is_some_and(|cell| self.free_at(cell))
    }

    pub fn free_near(&self, p: [f64; 2]) -> bool {
        self.cell_near(p).is_some_and(|cell| self.free_at(cell))
    }

    pub fn neighbours(&self, cell: [i32; 2]) -> Vec<[i32; 2]> {
        self.beluga().neighborhood4(cell)
    }

    pub fn neighbour_indices(&self, index: usize) -> Vec<usize> {
        let cells = self.neighbours(self.cell_of(index)).into_iter();
        cells.filter_map(|cell| self.index_at(cell)).collect()
    }

    pub fn free_cells(&self) -> Vec<usize> {
        self.beluga().free_cells()
    }

    pub fn obstacle_data(&self) -> Vec<bool> {
        self.beluga().obstacle_data()
    }

    pub fn unknown_mask(&self) -> Vec<bool> {
        self.beluga().unknown_mask()
    }

    pub fn obstacle_edge_mask(&self) -> Vec<bool> {
        self.beluga().obstacle_edge_mask()
    }

    pub fn trace(
        &self,
        [x, y, theta]: [f64; 3],
        bearing: f64,
        range: f32,
        supercover: bool,
    ) -> Vec<[i32; 2]> {
        self.beluga()
            .trace(Pose2D::new(x, y, theta), bearing, range, walk(supercover))
    }

    pub fn cast(&self, [x, y, theta]: [f64; 3], bearing: f64, range: f32, supercover: bool) -> Option<f64> {
        self.beluga()
            .cast(Pose2D::new(x, y, theta), bearing, range, walk(supercover))
    }
}

fn walk(supercover: bool) -> Walk {
    if supercover {
        Walk::Supercover
    } else {
        Walk::Standard
    }
}
