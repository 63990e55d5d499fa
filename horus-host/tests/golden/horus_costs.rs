//! HORUS: costs.

use serde_json::Value;

use crate::maps::{LiveMap, MapCase, assert_costs, assert_single_source};
use crate::subject::{CostParams, Grid, for_each_map, is_bad_parameter};
use crate::vectors::*;

/// Parameters of a HORUS vector; `None`, said by name, where they are errors here.
fn horus_params(name: &str, radius: f32, factor: &Value, lethal_cost: &Value) -> Option<CostParams> {
    let params = CostParams {
        inflation_radius: radius,
        cost_scaling_factor: factor.as_f64().map_or(f32::NAN, |k| k as f32),
        lethal_cost: int(lethal_cost) as u8,
        ..CostParams::horus()
    };
    match params.validate() {
        Ok(()) => Some(params),
        Err(error) => {
            println!("skipped: {name}: {error}");
            None
        }
    }
}

/// HORUS computes 2 * 64 in i8 and gets cost 0 where the seed's rule gives 128; nothing else depends on it.
fn with_cell_64_corrected(data: &[i8], golden: &[u8], lethal_cost: u8) -> Vec<u8> {
    let correct = |(&v, &cost): (&i8, &u8)| match v {
        64 => cost.max(128.min(lethal_cost - 1)),
        _ => cost,
    };
    data.iter().zip(golden).map(correct).collect()
}

/// Costs of one row of cells without inflation.
fn base_costs(data: Vec<i8>, lethal_cost: u8) -> Vec<u8> {
    let params = CostParams {
        inflation_radius: 0.0,
        lethal_cost,
        ..CostParams::horus()
    };
    let case = MapCase::new((data.len() as u32, 1), 0.05, data);
    let mut costs = Vec::new();
    for_each_map(&case, params, &mut |map| costs = map.costs()).unwrap();
    costs
}

/// Base costs for one lethal cost: occupancy -1 to 100 in order, with the cost HORUS gives and ours.
struct BaseCosts {
    lethal: u8,
    rows: Vec<(i8, u8, u8)>,
}

/// Every recorded set whose lethal cost is legal here.
fn base_cost_sets() -> Vec<BaseCosts> {
    let files = vectors("horus", "base_cost.json");
    let sets = files.iter().flat_map(|v| items(&v["sets"]));
    sets.filter_map(|set| {
        let lethal = u8::try_from(int(&set["lethal_cost"])).unwrap();
        let values: Vec<i8> = (-1..=100).collect();
        let golden = &costs_of(&set["costs_for_occ_-128..127"])[127..];
        (2..=254).contains(&lethal).then(|| {
            let ours = base_costs(values.clone(), lethal);
            let rows = values.into_iter().zip(golden).zip(ours);
            let rows = rows.map(|((value, &golden), ours)| (value, golden, ours));
            BaseCosts {
                lethal,
                rows: rows.collect(),
            }
        })
    })
    .collect()
}

#[test]
fn horus_base_cost() {
    let sets = base_cost_sets();
    assert!(!sets.is_empty());
    for BaseCosts { lethal, rows } in sets {
        for (value, golden, ours) in rows {
            let below_lethal = value < 65 && (value < 0 || (value as u8) * 2 < lethal);
            if value != 64 && (value >= 65 || below_lethal) {
                assert_eq!(ours, golden, "occupancy {value}, lethal {lethal}");
            }
        }
    }
}

#[test]
fn horus_deviation_occupancy_64_costs_128_instead_of_0() {
    for BaseCosts { lethal, rows } in base_cost_sets() {
        let (value, golden, ours) = rows[65];
        assert_eq!((value, golden, ours), (64, 0, 128.min(lethal - 1)));
    }
}

#[test]
fn horus_deviation_no_value_below_the_threshold_becomes_a_source() {
    let mut seen = 0;
    for BaseCosts { lethal, rows } in base_cost_sets() {
        for (value, golden, ours) in rows {
            if (0..64).contains(&value) && value as u8 * 2 >= lethal {
                assert_eq!((golden, ours), (value as u8 * 2, lethal - 1));
                seen += 1;
            }
        }
    }
    assert!(seen > 0);
}

#[test]
fn horus_deviation_values_outside_minus_1_to_100_cannot_be_set() {
    let mut grid = Grid::new(1, 1, 1.0, [0.0; 3]).unwrap();
    for (value, stored) in [(-128, -1), (-2, -1), (101, 100), (127, 100)] {
        assert!(grid.set_occupancy(0, 0, value));
        assert_eq!(grid.occupancy(0, 0), Some(stored));
    }
    // Brought in with a whole map, they are unknown and occupied.
    assert_eq!(base_costs(vec![-128, -2, 101, 127], 253), [255, 255, 253, 253]);
}

#[test]
fn horus_deviation_illegal_parameters_are_errors() {
    let legal = CostParams::horus();
    let bad_floats = [-1.0, f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
    let radii = bad_floats.map(|inflation_radius| CostParams {
        inflation_radius,
        ..legal
    });
    let factors = bad_floats.map(|cost_scaling_factor| CostParams {
        cost_scaling_factor,
        ..legal
    });
    let lethal = [0, 1, 255].map(|lethal_cost| CostParams { lethal_cost, ..legal });
    let case = MapCase::new((1, 1), 0.05, vec![0]);
    for params in radii.into_iter().chain(factors).chain(lethal) {
        let refused = for_each_map(&case, params, &mut |_| panic!("made with {params:?}"));
        assert!(refused.is_err_and(|e| is_bad_parameter(&e)), "{params:?}");
    }
}

#[test]
fn horus_cost_by_squared_distance() {
    let files = vectors("horus", "cost_lut.json");
    for set in files.iter().flat_map(|v| items(&v["sets"])) {
        let radius = f32_bits(&set["inflation_radius_f32_bits"]);
        let (factor, lethal) = (&set["cost_scaling_factor"], &set["lethal_cost"]);
        let Some(params) = horus_params("cost_lut", radius, factor, lethal) else {
            continue;
        };
        let row = |row: &Value| (int(&row[0]) as usize, int(&row[1]) as u8);
        let table: Vec<_> = items(&set["d2_cost"]).iter().map(row).collect();
        assert_single_source(f32_bits(&set["resolution_f32_bits"]), params, &table);
    }
}

#[test]
fn horus_cost_maps() {
    let mut compared = 0;
    for m in vectors("horus", "costmaps.json")
        .iter()
        .flat_map(|v| items(&v["maps"]))
    {
        let name = m["name"].as_str().unwrap();
        let radius = f32_bits(&m["inflation_radius_f32_bits"]);
        let (factor, lethal) = (&m["cost_scaling_factor"], &m["lethal_cost"]);
        let Some(params) = horus_params(name, radius, factor, lethal) else {
            continue;
        };
        let data = cells_of(&m["data"]);
        if data.iter().any(|v| !(-1..=100).contains(v)) {
            println!("skipped: {name}: values that cannot be set here");
            continue;
        }
        if data
            .iter()
            .any(|&v| v < 64 && i32::from(v) * 2 >= i32::from(params.lethal_cost))
        {
            println!("skipped: {name}: values below the threshold are sources in HORUS");
            continue;
        }
        let golden = with_cell_64_corrected(&data, &costs_of(&m["costs"]), params.lethal_cost);
        let case = MapCase::new(size_of(m), f32_bits(&m["resolution_f32_bits"]), data);
        assert_costs(&case, params, &golden, name);
        compared += 1;
    }
    assert!(compared > 0);
}

#[test]
fn horus_cost_map_after_each_change() {
    for s in vectors("horus", "sequences.json")
        .iter()
        .flat_map(|v| items(&v["sequences"]))
    {
        let name = s["name"].as_str().unwrap();
        let radius = f32_bits(&s["inflation_radius_f32_bits"]);
        let (factor, lethal) = (&s["cost_scaling_factor"], &s["lethal_cost"]);
        let Some(params) = horus_params(name, radius, factor, lethal) else {
            continue;
        };
        let (width, height) = size_of(s);
        let data = vec![int(&s["initial_fill"]) as i8; (width * height) as usize];
        let case = MapCase::new((width, height), f32_bits(&s["resolution_f32_bits"]), data);
        for_each_map(&case, params, &mut |map| replay(s, map, params.lethal_cost)).unwrap();
    }
}

/// Applies the changes of a sequence, one update after each.
fn replay(s: &Value, map: &mut dyn LiveMap, lethal_cost: u8) {
    let mut golden = costs_of(&s["initial_costs"]);
    assert_eq!(map.costs(), golden, "{}, {}", s["name"], map.way());
    for (i, step) in items(&s["steps"]).iter().enumerate() {
        let [x, y] = [0, 1].map(|i| int(&step[i]) as u32);
        assert!(map.set_occupancy(x, y, int(&step[2]) as i8));
        map.update();
        for change in items(&step[3]) {
            golden[int(&change[0]) as usize] = int(&change[1]) as u8;
        }
        let expected = with_cell_64_corrected(&map.cells(), &golden, lethal_cost);
        assert_eq!(map.costs(), expected, "{}, step {i}, {}", s["name"], map.way());
    }
    assert_eq!(golden, costs_of(&s["final_costs"]));
    assert_eq!(map.cells(), cells_of(&s["final_data"]));
}

/// Runs `check` on the map of `cost_lookup.json`; HORUS ignores its heading of 0.7 rad, so it is left out.
fn for_each_lookup_map(check: &mut dyn FnMut(&mut dyn LiveMap)) {
    let case = MapCase {
        width: 4,
        height: 3,
        resolution: 0.5,
        origin: [-1.0, 2.0, 0.0],
        cells: vec![0, 10, 64, 65, -1, 100, 0, 0, 0, 0, 0, 50],
    };
    let params = CostParams {
        inflation_radius: 0.0,
        ..CostParams::horus()
    };
    for_each_map(&case, params, check).unwrap();
}

#[test]
fn horus_cost_lookup() {
    for v in vectors("horus", "cost_lookup.json") {
        for_each_lookup_map(&mut |map| {
            let golden = costs_of(&v["costs"]);
            assert_eq!(map.costs(), with_cell_64_corrected(&map.cells(), &golden, 253));
            for case in items(&v["cases"]) {
                let (x, y) = (f64_bits(&case[0]), f64_bits(&case[1]));
                if let Some((gx, gy)) = map.world_to_grid(x, y) {
                    let golden = if (gx, gy) == (2, 0) { 128 } else { int(&case[4]) };
                    assert_eq!(
                        map.cost(x, y).map(i64::from),
                        Some(golden),
                        "{case}, {}",
                        map.way()
                    );
                }
            }
        });
    }
}

#[test]
fn horus_default_parameters() {
    for v in vectors("horus", "cost_lookup.json") {
        let (params, defaults) = (CostParams::default(), &v["defaults"]);
        assert_eq!(params.inflation_radius, f32_of(&defaults["inflation_radius"]));
        assert_eq!(
            params.cost_scaling_factor,
            f32_of(&defaults["cost_scaling_factor"])
        );
        assert_eq!(i64::from(params.lethal_cost), int(&defaults["lethal_cost"]));
    }
}

#[test]
fn horus_deviation_the_cost_outside_the_map_is_none_instead_of_lethal() {
    let files = vectors("horus", "cost_lookup.json");
    for_each_lookup_map(&mut |map| {
        let mut outside = 0;
        for case in files.iter().flat_map(|v| items(&v["cases"])) {
            let (x, y) = (f64_bits(&case[0]), f64_bits(&case[1]));
            let inside = (-1.0..0.9995).contains(&x) && (2.0..3.4995).contains(&y);
            assert_eq!(map.cost(x, y).is_some(), inside, "{case}, {}", map.way());
            outside += usize::from(!inside && int(&case[4]) == 253);
        }
        assert!(outside > 0);
    });
}

#[test]
fn horus_wire_bytes_end_in_the_parameters_of_the_costs() {
    for v in vectors("horus", "wire_bincode1.json") {
        let wire = bytes(&v["cost_map"]["hex"]);
        let [radius, factor] = [9, 5].map(|end| {
            let at = wire.len() - end;
            f32::from_le_bytes(wire[at..at + 4].try_into().unwrap())
        });
        let params = CostParams {
            inflation_radius: radius,
            cost_scaling_factor: factor,
            lethal_cost: wire[wire.len() - 1],
            ..CostParams::horus()
        };
        let grid = &v["occupancy_grid"]["json"];
        let cells = cells_of(&grid["data"]);
        let case = MapCase::new(size_of(grid), f32_of(&grid["resolution"]), cells);
        assert_costs(&case, params, &costs_of(&v["cost_map"]["costs"]), "wire_bincode1");
    }
}
