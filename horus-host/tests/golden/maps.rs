//! What the tests need of a cost map, whichever program keeps it.

use crate::subject::{CostParams, for_each_map};

/// The map a vector describes; its first corner lies at `origin` (x, y in metres, theta in radians).
#[derive(Debug, Default)]
pub struct MapCase {
    pub width: u32,
    pub height: u32,
    pub resolution: f32,
    pub origin: [f64; 3],
    /// Row-major, row 0 at the lowest y.
    pub cells: Vec<i8>,
}

impl MapCase {
    pub fn new((width, height): (u32, u32), resolution: f32, cells: Vec<i8>) -> Self {
        assert_eq!(cells.len(), width as usize * height as usize);
        Self {
            width,
            height,
            resolution,
            origin: [0.0; 3],
            cells,
        }
    }
}

/// A cost map under test; its costs are those of the last [`update`](Self::update).
pub trait LiveMap {
    fn set_occupancy(&mut self, gx: u32, gy: u32, value: i8) -> bool;
    fn update(&mut self);
    fn cells(&self) -> Vec<i8>;
    fn costs(&self) -> Vec<u8>;
    fn world_to_grid(&self, x: f64, y: f64) -> Option<(u32, u32)>;
    fn cost(&self, x: f64, y: f64) -> Option<u8>;
    /// Which of the subject's ways to keep a map this is.
    fn way(&self) -> &str;
}

/// Compares the costs of a map with recorded ones.
pub fn assert_costs(case: &MapCase, params: CostParams, golden: &[u8], name: &str) {
    let made = for_each_map(case, params, &mut |map| {
        assert_eq!(map.costs(), golden, "{name}, {}, {params:?}", map.way());
    });
    made.unwrap_or_else(|error| panic!("{name}: {error}"));
}

/// Compares the costs around a single obstacle with a table of costs by squared distance.
pub fn assert_single_source(resolution: f32, params: CostParams, table: &[(usize, u8)]) {
    let reach = table.iter().map(|&(d2, _)| d2.isqrt() + 1).max().unwrap_or(0);
    let width = reach + 1;
    let mut cells = vec![0; width * width];
    cells[0] = 100;
    let case = MapCase::new((width as u32, width as u32), resolution, cells);
    let made = for_each_map(&case, params, &mut |map| {
        let costs = map.costs();
        for &(d2, cost) in table {
            let places = (0..=reach).flat_map(|y| (0..=reach).map(move |x| (x, y)));
            let mut places = places.filter(|(x, y)| x * x + y * y == d2).peekable();
            assert!(places.peek().is_some(), "{d2} is no sum of two squares");
            for (x, y) in places {
                let got = costs[y * width + x];
                assert_eq!(got, cost, "{}, {params:?} at ({x}, {y})", map.way());
            }
        }
    });
    made.unwrap_or_else(|error| panic!("{params:?}: {error}"));
}
