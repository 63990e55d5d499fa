//! What only the std version has: f64 fields as they go over the wire, default maps, and the walk between two cells as
//! a public function (the walk of the core is tested against it, and by scans).

use horus_host::prelude::*;
use horus_host::reference::{walk_cell, walk_inside, walk_steps};

use crate::vectors::*;

#[test]
fn horus_wire_bytes_hold_the_same_fields() {
    for v in vectors("horus", "wire_bincode1.json") {
        let json = &v["occupancy_grid"]["json"];
        let [x, y, theta] = ["x", "y", "theta"].map(|k| json["origin"][k].as_f64().unwrap());
        let (width, height) = size_of(json);
        let resolution = f32_of(&json["resolution"]);
        let mut grid = OccupancyGrid::new(width, height, resolution, Pose2D::new(x, y, theta));
        grid.data = cells_of(&json["data"]);
        grid.set_frame_id("map");
        grid.metadata.copy_from_slice(&costs_of(&json["metadata"]));
        grid.timestamp_ns = json["timestamp_ns"].as_u64().unwrap();
        let mut wire = grid.resolution.to_le_bytes().to_vec();
        wire.extend([grid.width, grid.height].iter().flat_map(|n| n.to_le_bytes()));
        let Pose2D { x, y, theta } = grid.origin;
        wire.extend([x, y, theta].iter().flat_map(|n| n.to_le_bytes()));
        wire.extend(json["origin"]["timestamp_ns"].as_u64().unwrap().to_le_bytes());
        wire.extend((grid.data.len() as u64).to_le_bytes());
        wire.extend(grid.data.iter().map(|&v| v as u8));
        wire.extend(grid.frame_id);
        wire.extend(grid.metadata);
        wire.extend(grid.timestamp_ns.to_le_bytes());
        assert_eq!(wire, bytes(&v["occupancy_grid"]["hex"]));
    }
}

#[test]
fn horus_default_map() {
    for v in vectors("horus", "cost_lookup.json") {
        let (map, defaults) = (CostMap::default(), &v["defaults"]);
        let grid = &map.occupancy_grid;
        assert_eq!((grid.width, grid.height), size_of(defaults));
        assert_eq!(grid.resolution, f32_of(&defaults["grid_resolution"]));
    }
}

#[test]
fn nav2_lines_without_length_limits() {
    let mut compared = 0;
    for v in vectors("nav2", "raytrace.json") {
        let width = int(&v["width"]) as u32;
        for line in items(&v["lines"]) {
            if int(&line["max_length"]) != -1 || int(&line["min_length"]) != 0 {
                continue;
            }
            let [from, to] = ["from", "to"].map(|k| [int(&line[k][0]) as i32, int(&line[k][1]) as i32]);
            let golden: Vec<_> = items(&line["raytraceLine"]).iter().map(int).collect();
            let steps = 0..=walk_steps(from, to);
            let walk = steps.map(|i| walk_cell(from, to, i));
            let walk: Vec<_> = walk.map(|[x, y]| y * i64::from(width) + x).collect();
            assert_eq!(walk, golden, "{from:?} to {to:?}");
            let inside = walk_inside(from, to, width, width);
            assert!(inside.map(|(_, [x, y])| i64::from(y * width + x)).eq(golden));
            compared += 1;
        }
    }
    assert!(compared > 0);
}
