//! The subject of Beluga's vectors is the embedded core: a borrowed grid of trinary values.

use horus_core::distance::{DistanceBuffers, DistanceCell, DistanceMap, DistanceOptions, EnvelopeVertex};
use horus_core::grid::{
    DenseGrid2, Frame, GridView, LinearGrid2, OccupancyGrid2d, RegularGrid, TrinaryValues,
};
use horus_core::nalgebra::{Isometry2, UnitComplex, Vector2};
use horus_core::prelude::Pose2D;
use horus_core::raycast::{CellWalk, RayCaster, WalkRule};

/// How far a coordinate may be off, relative to 1 m or its own size.
pub const COORDINATE_ERROR: f64 = 1e-5;

fn cells(cells: impl Iterator<Item = Vector2<i32>>) -> Vec<[i32; 2]> {
    cells.map(|c| [c.x, c.y]).collect()
}

fn walk(from: [i32; 2], to: [i32; 2], rule: WalkRule) -> Vec<[i32; 2]> {
    cells(CellWalk::new(from.into(), to.into(), rule))
}

pub fn standard(from: [i32; 2], to: [i32; 2]) -> Vec<[i32; 2]> {
    walk(from, to, WalkRule::Standard)
}

pub fn supercover(from: [i32; 2], to: [i32; 2]) -> Vec<[i32; 2]> {
    walk(from, to, WalkRule::Supercover)
}

/// The distances by every way to compute them: in all four types of cells that hold the cap, without the sign.
pub fn squared_distances(mask: &[bool], width: u32, cap: u32) -> Vec<Vec<u32>> {
    let mut found = vec![
        distances::<u32>(mask, width, cap),
        distances::<i32>(mask, width, cap),
    ];
    if cap <= u16::MAX.into() {
        found.push(distances::<u16>(mask, width, cap));
    }
    if cap <= i16::MAX as u32 {
        found.push(distances::<i16>(mask, width, cap));
    }
    found
}

fn distances<D: DistanceCell>(mask: &[bool], width: u32, cap: u32) -> Vec<u32> {
    let values: Vec<i8> = mask.iter().map(|set| if *set { 100 } else { 0 }).collect();
    let height = (mask.len() as u32).checked_div(width).unwrap_or(0);
    let grid = GridView::new(&values, width, height, 1.0, Pose2D::default(), TrinaryValues).unwrap();
    let mut squared = vec![D::default(); mask.len()];
    let mut vertices = vec![EnvelopeVertex::EMPTY; 2 * width as usize];
    let mut map = DistanceMap::new_in(DistanceBuffers {
        cells: &mut squared,
        vertices: &mut vertices,
    });
    let options = DistanceOptions {
        max_squared: Some(cap),
        ..DistanceOptions::default()
    };
    map.compute(&grid, options).unwrap();
    let outside = |d: &D| if d.is_obstacle() { 0 } else { d.squared() };
    map.squared().iter().map(outside).collect()
}

pub struct Map {
    cells: Vec<i8>,
    width: u32,
    height: u32,
    resolution: f32,
    origin: Pose2D,
}

impl Map {
    pub fn new(width: u32, height: u32, resolution: f32, origin: [f64; 3], cells: Vec<i8>) -> Self {
        let [x, y, theta] = origin.map(|v| v as f32);
        Self {
            cells,
            width,
            height,
            resolution,
            origin: Pose2D::new(x, y, theta),
        }
    }

    fn view(&self) -> GridView<'_, TrinaryValues> {
        GridView::new(
            &self.cells,
            self.width,
            self.height,
            self.resolution,
            self.origin,
            TrinaryValues,
        )
        .unwrap()
    }

    pub fn cell_of(&self, index: usize) -> [i32; 2] {
        let index = index as u32;
        [(index % self.width) as i32, (index / self.width) as i32]
    }

    pub fn cell_near(&self, p: [f64; 2]) -> Option<[i32; 2]> {
        self.view().cell_near(point(p)).map(Into::into)
    }

    pub fn local_coordinates_at(&self, cell: [i32; 2]) -> [f64; 2] {
        double(
            self.view()
                .coordinates_at(Vector2::from(cell), Frame::Local)
                .unwrap(),
        )
    }

    pub fn local_coordinates_of(&self, index: usize) -> [f64; 2] {
        double(self.view().coordinates_at(index, Frame::Local).unwrap())
    }

    pub fn global_coordinates_of(&self, index: usize) -> [f64; 2] {
        double(self.view().coordinates_at(index, Frame::Global).unwrap())
    }

    pub fn global_coordinates_for_free_cells(&self) -> Vec<[f64; 2]> {
        let view = self.view();
        let coordinates = view.coordinates_for(view.free_cells(), Frame::Global);
        coordinates.map(double).collect()
    }

    pub fn data_at(&self, [x, y]: [i32; 2]) -> Option<i8> {
        assert_eq!(
            self.view().contains((x, y)),
            self.view().data_at((x, y)).is_some()
        );
        self.view().data_at((x, y))
    }

    pub fn data_at_index(&self, index: usize) -> Option<i8> {
        self.view().data_at(index)
    }

    pub fn data_near(&self, p: [f64; 2]) -> Option<i8> {
        self.view().data_near(point(p))
    }

    pub fn index_at(&self, [x, y]: [i32; 2]) -> Option<usize> {
        self.view().index_at((x, y))
    }

    pub fn free_at(&self, [x, y]: [i32; 2]) -> bool {
        self.view().free_at((x, y))
    }

    pub fn free_at_index(&self, index: usize) -> bool {
        self.view().free_at(index)
    }

    pub fn free_near(&self, p: [f64; 2]) -> bool {
        self.view().free_near(point(p))
    }

    pub fn neighbours(&self, [x, y]: [i32; 2]) -> Vec<[i32; 2]> {
        cells(self.view().neighborhood4((x, y)))
    }

    pub fn neighbour_indices(&self, index: usize) -> Vec<usize> {
        self.view().neighborhood4(index).collect()
    }

    pub fn free_cells(&self) -> Vec<usize> {
        self.view().free_cells().collect()
    }

    pub fn obstacle_data(&self) -> Vec<bool> {
        self.view().obstacle_data().collect()
    }

    pub fn unknown_mask(&self) -> Vec<bool> {
        self.view().unknown_mask().collect()
    }

    pub fn obstacle_edge_mask(&self) -> Vec<bool> {
        self.view().obstacle_edge_mask().collect()
    }

    pub fn trace(&self, pose: [f64; 3], bearing: f64, range: f32, supercover: bool) -> Vec<[i32; 2]> {
        let view = self.view();
        cells(rays(&view, pose, range, supercover).trace(UnitComplex::new(bearing as f32)))
    }

    pub fn cast(&self, pose: [f64; 3], bearing: f64, range: f32, supercover: bool) -> Option<f64> {
        let view = self.view();
        let cast = rays(&view, pose, range, supercover).cast(UnitComplex::new(bearing as f32));
        cast.map(f64::from)
    }
}

fn rays<'a, 'b>(
    view: &'a GridView<'b, TrinaryValues>,
    pose: [f64; 3],
    range: f32,
    supercover: bool,
) -> RayCaster<'a, GridView<'b, TrinaryValues>> {
    let [x, y, theta] = pose.map(|v| v as f32);
    let rule = if supercover {
        WalkRule::Supercover
    } else {
        WalkRule::Standard
    };
    RayCaster::new(view, Isometry2::new(Vector2::new(x, y), theta), range, rule)
}

fn point(p: [f64; 2]) -> (f32, f32) {
    (p[0] as f32, p[1] as f32)
}

fn double(p: Vector2<f32>) -> [f64; 2] {
    [p.x.into(), p.y.into()]
}
