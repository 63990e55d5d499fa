use super::super::inflation::inflated_cost;
use super::super::{CostMap, CostParams, Decay, OccupancyGrid, Pose2D, ReferenceError};
use super::{Numbers, picture};

fn row(data: &[i8], params: CostParams) -> Vec<u8> {
    let mut grid = OccupancyGrid::new(data.len() as u32, 1, 0.05, Pose2D::default());
    grid.data = data.to_vec();
    CostMap::with_params(grid, params).unwrap().costs
}

#[test]
fn the_default_cost_falls_as_the_seed_says() {
    let costs = row(&[100, 0, 0, 0, 0, 0, -1, 20], CostParams::default());
    assert_eq!(costs, [253, 97, 33, 10, 2, 0, 255, 40]);
}

#[test]
fn base_costs_stay_below_lethal() {
    let params = CostParams {
        inflation_radius: 0.0,
        lethal_cost: 100,
        lethal_threshold: 100,
        ..CostParams::default()
    };
    assert_eq!(row(&[-1, 0, 49, 50, 99, 100], params), [255, 0, 98, 99, 99, 100]);
}

#[test]
fn unknown_cells_are_sources_only_on_request() {
    let unknown_inflates = CostParams {
        unknown_inflates: true,
        ..CostParams::default()
    };
    assert_eq!(row(&[-1, 0, 0], CostParams::default()), [255, 0, 0]);
    assert_eq!(row(&[-1, 0, 0], unknown_inflates), [255, 97, 33]);
}

#[test]
fn nav2_decay_and_merge() {
    let nav2 = CostParams::nav2();
    let costs = row(&[100, 0, -1, 0, -1], nav2);
    assert_eq!(costs, [254, 253, 253, 152, 255]);
    let inflate_unknown = CostParams {
        inflate_unknown: true,
        ..nav2
    };
    assert_eq!(
        row(&[100, 0, -1, 0, -1], inflate_unknown),
        [254, 253, 253, 152, 92]
    );
    // An unknown source is at distance 0 from itself.
    let unknown_inflates = CostParams {
        unknown_inflates: true,
        ..nav2
    };
    assert_eq!(row(&[-1, 0, 0, 0], unknown_inflates), [254, 253, 253, 152]);
    // The radius is rounded up to whole cells, a whole number of cells is not.
    for (inflation_radius, cells) in [(0.0, 0), (0.01, 1), (0.05, 1), (0.051, 2), (0.35, 7)] {
        let params = CostParams {
            inflation_radius,
            cost_scaling_factor: 0.0,
            ..nav2
        };
        let costs = row(&[100, 0, 0, 0, 0, 0, 0, 0, 0, 0], params);
        assert_eq!(
            costs.iter().filter(|&&c| c > 0).count(),
            cells + 1,
            "{inflation_radius} m"
        );
    }
}

#[test]
fn the_radius_itself_still_counts() {
    let params = CostParams {
        inflation_radius: 0.1,
        cost_scaling_factor: 0.0,
        ..CostParams::default()
    };
    assert_eq!(row(&[100, 0, 0, 0], params), [253, 252, 252, 0]);
}

/// The cost of a cell is that of its nearest source, whatever the sources' order.
#[test]
fn only_the_nearest_source_matters() {
    let mut numbers = Numbers(5);
    for decay in [Decay::Polynomial, Decay::Exponential] {
        let mut grid = OccupancyGrid::new(30, 20, 0.05, Pose2D::default());
        grid.data.fill(0);
        for _ in 0..12 {
            grid.set_occupancy(numbers.below(30), numbers.below(20), 100);
        }
        let params = CostParams {
            decay,
            cost_scaling_factor: 2.0,
            ..CostParams::default()
        };
        let costs = CostMap::with_params(grid.clone(), params).unwrap().costs;
        for (gx, gy) in (0..30).flat_map(|gx| (0..20).map(move |gy| (gx, gy))) {
            let sources = (0..600u32).filter(|&i| grid.data[i as usize] == 100);
            let d2 = |i: u32| (i % 30).abs_diff(gx).pow(2) + (i / 30).abs_diff(gy).pow(2);
            let nearest = sources.min_by_key(|&i| d2(i)).unwrap();
            let mut alone = grid.clone();
            alone.data.fill(0);
            alone.set_occupancy(nearest % 30, nearest / 30, 100);
            let alone = CostMap::with_params(alone, params).unwrap().costs;
            let i = (gy * 30 + gx) as usize;
            assert_eq!(costs[i], alone[i], "({gx}, {gy})");
        }
    }
}

#[test]
fn look_ups() {
    let mut map = CostMap::from_occupancy_grid(picture(&["#?", ".."]), 0.0);
    assert_eq!(map.cost(0.5, 1.5), Some(253));
    assert_eq!(map.cost(1.5, 1.5), Some(255));
    assert_eq!(map.cost(0.0, 0.0), Some(0));
    for (x, y) in [
        (2.0, 0.5),
        (-0.1, 0.5),
        (0.5, 2.0),
        (f64::NAN, 0.5),
        (0.5, f64::INFINITY),
    ] {
        assert_eq!(map.cost(x, y), None);
    }
    map.occupancy_grid.recenter(Pose2D::new(2.0, 1.0, 0.0)).unwrap();
    map.compute_costs();
    assert_eq!((map.cost(1.5, 1.5), map.cost(2.5, 1.5)), (Some(255), Some(255)));
    assert_eq!((map.cost(1.5, 0.5), map.cost(0.5, 0.5)), (Some(0), None));
}

#[test]
fn parameters_outside_their_range_are_errors() {
    let good = CostParams::default();
    let bad = [
        (
            "inflation_radius",
            CostParams {
                inflation_radius: -0.1,
                ..good
            },
        ),
        (
            "inflation_radius",
            CostParams {
                inflation_radius: f32::NAN,
                ..good
            },
        ),
        (
            "cost_scaling_factor",
            CostParams {
                cost_scaling_factor: f32::INFINITY,
                ..good
            },
        ),
        (
            "inscribed_radius",
            CostParams {
                inscribed_radius: -1.0,
                ..good
            },
        ),
        (
            "lethal_cost",
            CostParams {
                lethal_cost: 1,
                ..good
            },
        ),
        (
            "lethal_cost",
            CostParams {
                lethal_cost: 255,
                ..good
            },
        ),
        (
            "lethal_threshold",
            CostParams {
                lethal_threshold: 0,
                ..good
            },
        ),
        (
            "lethal_threshold",
            CostParams {
                lethal_threshold: 101,
                ..good
            },
        ),
    ];
    for (field, params) in bad {
        match CostMap::with_params(picture(&["."]), params) {
            Err(ReferenceError::CostParam { name, .. }) => assert_eq!(name, field),
            other => panic!("{other:?}"),
        }
    }
    let error = CostParams {
        lethal_cost: 1,
        ..good
    }
    .validate()
    .unwrap_err();
    assert_eq!(error.to_string(), "lethal_cost must be 2 to 254, not 1");
}

#[test]
#[should_panic = "inflation_radius must be finite and not negative, not -1"]
fn from_occupancy_grid_panics_where_with_params_errs() {
    CostMap::from_occupancy_grid(OccupancyGrid::default(), -1.0);
}

#[test]
fn parameters_are_kept() {
    let params = CostParams {
        inscribed_radius: 0.3,
        inflate_unknown: true,
        ..CostParams::nav2()
    };
    assert_eq!(
        CostMap::with_params(picture(&["."]), params).unwrap().params(),
        params
    );
    assert_eq!(CostMap::default().params(), CostParams::default());
}

#[test]
fn illegal_values_written_into_the_fields_do_no_harm() {
    let floats = [-1.0, 0.0, f32::NAN, f32::INFINITY, f32::MIN_POSITIVE];
    for (value, lethal) in floats.into_iter().flat_map(|v| [0, 255].map(|l| (v, l))) {
        for decay in [Decay::Polynomial, Decay::Exponential] {
            let mut map = CostMap::from_occupancy_grid(picture(&["#.?", "..."]), 1.0);
            map.inflation_radius = value;
            map.cost_scaling_factor = value;
            map.inscribed_radius = value;
            map.lethal_cost = lethal;
            map.decay = decay;
            map.occupancy_grid.resolution = value;
            map.occupancy_grid.data.truncate(5);
            map.compute_costs();
            assert_eq!(map.costs.len(), 5);
            map.occupancy_grid.width = 0;
            map.compute_costs();
        }
    }
}

#[test]
fn a_radius_of_whole_cells_reaches_exactly_that_far() {
    for hundredths in [1, 2, 5, 10, 20, 25, 50] {
        for cells in 1..=255u64 {
            let params = CostParams {
                inflation_radius: (hundredths * cells) as f32 / 100.0,
                cost_scaling_factor: 0.0,
                inscribed_radius: 0.0,
                ..CostParams::nav2()
            };
            let resolution = hundredths as f32 / 100.0;
            let cost = |d: u64| inflated_cost(d * d, resolution, &params);
            assert_eq!(
                (cost(cells), cost(cells + 1)),
                (252, 0),
                "{cells} cells of {resolution} m"
            );
        }
    }
}

#[test]
fn inflate_unknown_takes_any_cost_above_0() {
    let params = CostParams {
        inflation_radius: 1.0,
        inflate_unknown: true,
        ..CostParams::nav2()
    };
    let mut data = vec![-1; 15];
    data[0] = 100;
    assert_eq!(row(&data, params)[10..], [4, 2, 1, 1, 255]);
}
