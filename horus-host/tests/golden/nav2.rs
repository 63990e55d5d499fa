//! nav2: inflation.

use serde_json::Value;

use crate::maps::{MapCase, assert_single_source};
use crate::subject::{CostParams, for_each_map, inflate_base_costs};
use crate::vectors::*;

fn nav2_params(case: &Value) -> CostParams {
    CostParams {
        inflation_radius: f32_of(&case["inflation_radius"]),
        inscribed_radius: f32_of(&case["inscribed_radius"]),
        cost_scaling_factor: f32_of(&case["cost_scaling_factor"]),
        inflate_unknown: case["inflate_unknown"] == true,
        unknown_inflates: case["inflate_around_unknown"] == true,
        ..CostParams::nav2()
    }
}

#[test]
fn nav2_inflation_formula() {
    let mut compared = 0;
    let files = vectors("nav2", "inflation.json");
    for case in files.iter().flat_map(|v| items(&v["cases"])) {
        let (width, height) = size_of(case);
        let (params, resolution) = (nav2_params(case), f32_of(&case["resolution"]));
        let (input, golden) = (bytes(&case["input"]), bytes(&case["formula"]));
        let window: Vec<_> = items(&case["window"]).iter().map(|v| int(v) as usize).collect();
        let mut check = |costs: &[u8], way: &str| {
            for y in window[1]..window[3] {
                let row = y * width as usize;
                let row = row + window[0]..row + window[2];
                assert_eq!(costs[row.clone()], golden[row], "{}, row {y}, {way}", case["id"]);
            }
            compared += 1;
        };
        let occupancy = |&byte: &u8| match byte {
            0 => Some(0),
            254 => Some(100),
            255 => Some(-1),
            _ => None,
        };
        if let Some(cells) = input.iter().map(occupancy).collect() {
            let map = MapCase::new((width, height), resolution, cells);
            for_each_map(&map, params, &mut |map| check(&map.costs(), map.way())).unwrap();
        } else if let Some(costs) = inflate_base_costs(&input, width, resolution, params) {
            check(&costs, "from base costs");
        } else {
            println!("skipped: {}: no occupancy has these base costs", case["id"]);
        }
    }
    assert!(compared > 0);
}

#[test]
fn nav2_cost_by_squared_distance() {
    let files = vectors("nav2", "cost_lut.json");
    for set in files.iter().flat_map(|v| items(&v["tables"])) {
        let costs = items(&set["d2"]).iter().zip(items(&set["formula"]));
        let table: Vec<_> = costs.map(|(d2, c)| (int(d2) as usize, int(c) as u8)).collect();
        assert_single_source(f32_of(&set["resolution"]), nav2_params(set), &table);
    }
}

#[test]
fn nav2_costs_after_each_tick() {
    fn fnv1a32(bytes: &[u8]) -> u32 {
        let step = |hash: u32, &byte: &u8| (hash ^ u32::from(byte)).wrapping_mul(16_777_619);
        bytes.iter().fold(2_166_136_261, step)
    }
    let files = vectors("nav2", "incremental.json");
    for s in files.iter().flat_map(|v| items(&v["sequences"])) {
        let lethal = |&byte: &u8| if byte == 254 { 100 } else { 0 };
        let cells = bytes(&s["initial"]).iter().map(lethal).collect();
        let case = MapCase::new(size_of(s), f32_of(&s["resolution"]), cells);
        for_each_map(&case, nav2_params(s), &mut |map| {
            for (i, tick) in items(&s["ticks"]).iter().enumerate() {
                for set in items(&tick["set"]) {
                    let [x, y] = [0, 1].map(|i| int(&set[i]) as u32);
                    assert!(map.set_occupancy(x, y, int(&set[2]) as i8 * 100));
                }
                map.update();
                let hash = i64::from(fnv1a32(&map.costs()));
                assert_eq!(hash, int(&tick["fnv_cost"]), "tick {i}, {}", map.way());
            }
            // The full set also holds the last map itself, for reading.
            if s["final_cost"].is_string() {
                assert_eq!(map.costs(), bytes(&s["final_cost"]));
            }
        })
        .unwrap();
    }
}
