//! Beluga: grid requirements, cell walks, rays and exact distances.

use serde_json::Value;

use crate::beluga_subject::{self as subject, Map};
use crate::vectors::*;

/// Cells from a boundary within which a point lies on it however its decimals were rounded.
const NOMINAL: f64 = 1e-6;
/// Cells from a boundary from which on every subject agrees with Beluga.
const CLEAR: f64 = 2e-3;

fn floats(value: &Value) -> [f64; 2] {
    [0, 1].map(|i| value[i].as_f64().expect("a number"))
}

fn cell_of(value: &Value) -> [i32; 2] {
    [0, 1].map(|i| int(&value[i]) as i32)
}

fn pairs(value: &Value) -> Vec<[i32; 2]> {
    let flat: Vec<i32> = items(value).iter().map(|v| int(v) as i32).collect();
    flat.chunks(2).map(|c| [c[0], c[1]]).collect()
}

fn flags(value: &Value) -> Vec<bool> {
    items(value).iter().map(|v| int(v) != 0).collect()
}

fn indices(value: &Value) -> Vec<usize> {
    items(value).iter().map(|v| int(v) as usize).collect()
}

fn map_of(case: &Value) -> Map {
    let origin = &case["origin"];
    let (width, height) = size_of(case);
    let pose = ["x", "y", "theta"].map(|key| origin[key].as_f64().unwrap());
    Map::new(
        width,
        height,
        f32_of(&case["resolution"]),
        pose,
        cells_of(&case["data"]),
    )
}

/// The cell that a point is expected in: on a nominal boundary the upper one, whatever Beluga's decimals say; `None`
/// if it is too near to a boundary to tell.
fn expected_cell(p: [f64; 2], golden: [i32; 2], resolution: f64) -> Option<[i32; 2]> {
    let mut cell = golden;
    for axis in 0..2 {
        let q = p[axis] / resolution;
        let distance = (q - q.round()).abs();
        if distance < NOMINAL {
            cell[axis] = q.round() as i32;
        } else if distance < CLEAR {
            return None;
        }
    }
    Some(cell)
}

fn assert_close(found: [f64; 2], golden: [f64; 2], what: &str) {
    for axis in 0..2 {
        let scale = golden[axis].abs().max(1.0);
        let error = (found[axis] - golden[axis]).abs();
        assert!(
            error <= subject::COORDINATE_ERROR * scale,
            "{what}: {found:?}, {golden:?}"
        );
    }
}

#[test]
fn beluga_regular_grids() {
    let (mut compared, mut boundaries) = (0, 0);
    for case in vectors("beluga", "regular_grid.json")
        .iter()
        .flat_map(|v| items(&v["cases"]))
    {
        let resolution = case["resolution"].as_f64().unwrap();
        let map = Map::new(1, 1, resolution as f32, [0.0; 3], vec![0]);
        for query in items(&case["cell_near"]) {
            let (p, golden) = (floats(&query["p"]), cell_of(&query["cell"]));
            if let Some(cell) = expected_cell(p, golden, resolution) {
                assert_eq!(map.cell_near(p), Some(cell), "{p:?} at {resolution}");
                compared += 1;
                boundaries += usize::from(cell != golden);
            }
        }
        for query in items(&case["coordinates_at"]) {
            let (cell, golden) = (cell_of(&query["cell"]), floats(&query["p"]));
            assert_close(map.local_coordinates_at(cell), golden, "coordinates_at");
        }
    }
    println!("{compared} points, {boundaries} of them on boundaries that Beluga rounds down");
    assert!(compared > 0);
}

#[test]
fn beluga_occupancy_grids() {
    let mut queries = 0;
    for case in vectors("beluga", "occupancy_grid.json")
        .iter()
        .flat_map(|v| items(&v["cases"]))
    {
        let map = map_of(case);
        let name = &case["name"];
        assert_eq!(map.free_cells(), indices(&case["free_cells"]), "{name}");
        assert_eq!(map.obstacle_data(), flags(&case["obstacle_mask"]), "{name}");
        assert_eq!(map.unknown_mask(), flags(&case["unknown_mask"]), "{name}");
        assert_eq!(
            map.obstacle_edge_mask(),
            flags(&case["obstacle_edge_mask"]),
            "{name}"
        );
        for (i, free) in flags(&case["free_at_index"]).into_iter().enumerate() {
            assert_eq!(map.free_at_index(i), free, "{name}, index {i}");
        }
        for (i, value) in items(&case["data_at_index"]).iter().enumerate() {
            assert_eq!(
                map.data_at_index(i).map(i64::from),
                value.as_i64(),
                "{name}, index {i}"
            );
        }
        for query in items(&case["cells"]) {
            let cell = cell_of(&query["cell"]);
            assert_eq!(
                map.data_at(cell).is_some(),
                query["contains"].as_bool().unwrap(),
                "{name}, {cell:?}"
            );
            assert_eq!(
                map.data_at(cell).map(i64::from),
                query["data_at"].as_i64(),
                "{name}, {cell:?}"
            );
            let index = query["index_at"].as_u64().map(|i| i as usize);
            assert_eq!(map.index_at(cell), index, "{name}, {cell:?}");
            assert_eq!(
                map.free_at(cell),
                query["free_at_spec"].as_bool().unwrap(),
                "{name}, {cell:?}"
            );
            queries += 1;
        }
        for query in items(&case["indices"]) {
            let i = int(&query["index"]) as usize;
            assert_close(map.local_coordinates_of(i), floats(&query["local"]), "local");
            assert_close(map.global_coordinates_of(i), floats(&query["global"]), "global");
            assert_eq!(
                map.neighbour_indices(i),
                indices(&query["neighborhood4"]),
                "{name}, index {i}"
            );
            let cells: Vec<_> = items(&query["neighborhood4_cells"]).iter().map(cell_of).collect();
            assert_eq!(map.neighbours(map.cell_of(i)), cells, "{name}, index {i}");
        }
        let golden = items(&case["coordinates_for_free_cells_global"]);
        let coordinates = map.global_coordinates_for_free_cells();
        assert_eq!(coordinates.len(), golden.len(), "{name}");
        for (found, golden) in coordinates.into_iter().zip(golden) {
            assert_close(found, floats(golden), "coordinates_for");
        }
        let resolution = case["resolution"].as_f64().unwrap();
        for query in items(&case["points"]) {
            let (p, golden) = (floats(&query["p"]), cell_of(&query["cell"]));
            if expected_cell(p, golden, resolution) != Some(golden) {
                continue;
            }
            assert_eq!(map.cell_near(p), Some(golden), "{name}, {p:?}");
            assert_eq!(
                map.data_near(p).map(i64::from),
                query["data_near"].as_i64(),
                "{name}, {p:?}"
            );
            assert_eq!(
                map.free_near(p),
                query["free_near_spec"].as_bool().unwrap(),
                "{name}, {p:?}"
            );
            queries += 1;
        }
    }
    assert!(queries > 0);
}

#[test]
fn beluga_cell_walks() {
    let mut compared = 0;
    for case in vectors("beluga", "bresenham.json")
        .iter()
        .flat_map(|v| items(&v["cases"]))
    {
        let (from, to) = (cell_of(&case["from"]), cell_of(&case["to"]));
        assert_eq!(
            subject::standard(from, to),
            pairs(&case["standard"]),
            "{from:?} {to:?}"
        );
        assert_eq!(
            subject::supercover(from, to),
            pairs(&case["supercover"]),
            "{from:?} {to:?}"
        );
        compared += 1;
    }
    assert!(compared > 0);
}

#[test]
fn beluga_rays() {
    let mut compared = 0;
    for case in vectors("beluga", "raycast.json")
        .iter()
        .flat_map(|v| items(&v["cases"]))
    {
        let map = map_of(case);
        for ray in items(&case["rays"]) {
            if ray["border_distance_cells"].as_f64().unwrap() < CLEAR {
                continue;
            }
            let pose = [0, 1, 2].map(|i| ray["pose"][i].as_f64().unwrap());
            let (bearing, range) = (ray["bearing"].as_f64().unwrap(), f32_of(&ray["max_range"]));
            for (supercover, kind) in [(false, "standard"), (true, "supercover")] {
                let what = format!("{}, {kind}, {ray}", case["name"]);
                let trace = map.trace(pose, bearing, range, supercover);
                assert_eq!(trace, pairs(&ray[&format!("trace_{kind}")]), "{what}");
                let (found, golden) = (
                    map.cast(pose, bearing, range, supercover),
                    ray[&format!("cast_{kind}")].as_f64(),
                );
                assert_eq!(found.is_some(), golden.is_some(), "{what}");
                if let Some((found, golden)) = found.zip(golden) {
                    assert!(
                        (found - golden).abs() <= 1e-5 * golden.max(1.0),
                        "{what}: {found}"
                    );
                }
                compared += 1;
            }
        }
    }
    assert!(compared > 0);
}

#[test]
fn beluga_exact_distances() {
    let mut compared = 0;
    for vectors in vectors("beluga", "distance_map.json") {
        for case in items(&vectors["grid_cases"]) {
            let (width, _) = size_of(case);
            let cap = int(&case["max_d2"]) as u32;
            let exact: Vec<u32> = items(&case["exact_d2"]).iter().map(|v| int(v) as u32).collect();
            let mask = flags(&case["mask"]);
            for found in subject::squared_distances(&mask, width, cap) {
                assert_eq!(found, exact, "{}", case["name"]);
            }
            let beluga = items(&case["beluga_d2"]).iter().map(|v| int(v) as u32);
            assert!(exact.iter().zip(beluga).all(|(exact, beluga)| beluga >= *exact));
            compared += 1;
        }
        for case in items(&vectors["line_cases"]) {
            let mask = flags(&case["mask"]);
            let max = int(&case["max"]) as u32;
            let golden = items(&case["distance"]).iter().map(|v| (int(v) as u32).pow(2));
            let golden: Vec<u32> = golden.collect();
            for found in subject::squared_distances(&mask, mask.len() as u32, max * max) {
                assert_eq!(found, golden, "{}", case["name"]);
            }
        }
    }
    assert!(compared > 0);
}
