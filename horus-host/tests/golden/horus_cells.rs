//! HORUS: cell values.

use crate::maps::MapCase;
use crate::subject::{Grid, cell_of_value};
use crate::vectors::*;

#[test]
fn horus_set_and_get() {
    for v in vectors("horus", "set_get.json") {
        let case = MapCase::new((3, 2), 1.0, cells_of(&v["initial_data"]));
        let mut grid = Grid::of(&case).unwrap();
        for case in items(&v["cases"]) {
            let (gx, gy) = (int(&case[0]) as u32, int(&case[1]) as u32);
            let set = grid.set_occupancy(gx, gy, int(&case[2]) as i8);
            assert_eq!(Some(set), case[3].as_bool(), "{case}");
            let value = grid.occupancy(gx, gy).map(i64::from);
            assert_eq!(value, case[4].as_i64(), "{case}");
        }
        assert_eq!(grid.cells(), cells_of(&v["final_data"]));
    }
}

#[test]
fn horus_is_free_and_is_occupied() {
    for v in vectors("horus", "queries.json") {
        for case in items(&v["by_value"]["cases"]) {
            let (is_free, is_occupied, value) = cell_of_value(int(&case[0]) as i8);
            assert_eq!(Some(is_free), case[1].as_bool(), "{case}");
            assert_eq!(Some(is_occupied), case[2].as_bool(), "{case}");
            assert_eq!(value.map(i64::from), case[3].as_i64());
        }
    }
}

#[test]
fn horus_deviation_a_nan_point_is_neither_free_nor_occupied() {
    for v in vectors("horus", "queries.json") {
        let grid = Grid::of(&MapCase::new((2, 2), 1.0, vec![0, 49, 50, 100])).unwrap();
        for case in items(&v["by_point"]["cases"]) {
            let (x, y) = (f64_bits(&case[0]), f64_bits(&case[1]));
            let golden = [4, 5].map(|i| case[i].as_bool().unwrap());
            let is_nan = x.is_nan() || y.is_nan();
            let expected = if is_nan { [false, false] } else { golden };
            assert_eq!([grid.is_free(x, y), grid.is_occupied(x, y)], expected, "{case}");
        }
    }
}
