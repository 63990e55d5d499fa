//! What fuzzing found, each as the test it became.

use horus_core::costmap::{CostMapBuffers, FieldCell, bit_words};
use horus_core::prelude::*;
use horus_host::reference as std_side;

fn map<'a, F: FieldCell>(
    (cells, buffers): (&'a mut [i8], CostBuffers<'a, F>),
    (width, height): (u32, u32),
    resolution: f32,
    params: CostParams,
) -> CostMap<'a, F> {
    let grid = OccupancyGrid::new_in(cells, width, height, resolution, Pose2D::default()).unwrap();
    CostMap::new_in(grid, buffers, params).unwrap()
}

/// The squared distances 254 and 255 mean "stale" and "none" in a one-byte field.
#[test]
fn no_source_costs_nothing_at_the_edge_of_a_one_byte_field() {
    for (resolution, radius, factor) in [(0.5, 8.0, 0.1), (1.0, 15.97, 0.5)] {
        let params = CostParams {
            cost_scaling_factor: factor,
            ..CostParams::default().with_radius(radius)
        };
        let mut buffers = CostMapBuffers::<7, { bit_words(7, 1) }>::empty();
        let mut map = map(buffers.split(), (7, 1), resolution, params);
        map.load(&[0; 7]).unwrap();
        assert!(map.row(0).all(|cost| cost == 0));
        assert_eq!(map.effective_radius(), 15);
    }
}

/// Costs near 255 cells were lost when the end of the reach did not fit 16 bits.
#[test]
fn costs_reach_to_the_edge_of_a_two_byte_field() {
    const WORDS: usize = bit_words(256, 24);
    for radius in [256.0, 255.999] {
        let params = CostParams {
            cost_scaling_factor: 0.1,
            ..CostParams::default().with_radius(radius)
        };
        let mut buffers = Box::new(CostMapBuffers::<{ 256 * 24 }, WORDS, u16, 2048>::empty());
        let mut map = map(buffers.split(), (256, 24), 1.0, params);
        let mut cells = vec![0i8; 256 * 24];
        cells[0] = 100;
        map.load(&cells).unwrap();
        let mut grid = std_side::OccupancyGrid::new(256, 24, 1.0, std_side::Pose2D::default());
        grid.data = cells;
        let params = std_side::CostParams {
            cost_scaling_factor: 0.1,
            inflation_radius: radius,
            ..std_side::CostParams::default()
        };
        let expected = std_side::CostMap::with_params(grid, params).unwrap().costs;
        let got: Vec<u8> = (0..24).flat_map(|gy| map.row(gy).collect::<Vec<_>>()).collect();
        assert_eq!(got, expected);
    }
}

/// Their field starts at distance 0, which must not show.
#[test]
fn new_cells_are_unknown_at_once() {
    let mut buffers = CostMapBuffers::<9, { bit_words(9, 1) }>::empty();
    let mut map = map(buffers.split(), (9, 1), 1.0, CostParams::nav2().with_radius(2.0));
    map.load(&[0; 9]).unwrap();
    assert_eq!(map.recenter(Pose2D::new(6.5, 0.5, 0.0)), Ok([2, 0]));
    let costs: Vec<u8> = map.row(0).collect();
    assert_eq!(costs, [0, 0, 0, 0, 0, 0, 0, 255, 255]);
    map.update_costs();
    assert_eq!(map.row(0).collect::<Vec<u8>>(), costs);
}

/// A saturated shift put the window somewhere else.
#[test]
fn a_shift_that_does_not_fit_is_refused() {
    let mut cells = [0i8; 16];
    let mut grid = OccupancyGrid::new_in(&mut cells[..], 4, 4, 1.0, Pose2D::default()).unwrap();
    let mut reference = std_side::OccupancyGrid::new(4, 4, 1.0, std_side::Pose2D::default());
    for (x, accepted) in [(-1_073_741_824.0, true), (1e30, false), (0.0, true)] {
        assert_eq!(grid.recenter(Pose2D::new(x, 0.0, 0.0)).is_ok(), accepted, "{x}");
        assert_eq!(
            reference
                .recenter(std_side::Pose2D::new(x.into(), 0.0, 0.0))
                .is_ok(),
            accepted,
            "{x}"
        );
    }
}

/// Where f32 no longer resolves cells, the crossing of an edge is noise.
#[test]
fn footprints_agree_far_from_the_first_origin() {
    let start = std_side::OccupancyGrid::new(8, 8, 1.0, std_side::Pose2D::default());
    let params = std_side::CostParams {
        inflation_radius: 0.0,
        ..std_side::CostParams::default()
    };
    let polygon = [
        (3.6875, 4.9375),
        (3.6875, 4.0625),
        (197_300_060.0, -118_380_030.0),
    ];
    for (gx, gy) in (0..3).flat_map(|gx| (0..5).map(move |gy| (gx, gy))) {
        let mut grid = start.clone();
        grid.data.fill(0);
        grid.set_occupancy(gx, gy, 100);
        let mut buffers = CostMapBuffers::<64, { bit_words(8, 8) }>::empty();
        let mut map = map(
            buffers.split(),
            (8, 8),
            1.0,
            CostParams::default().with_radius(0.0),
        );
        map.load(&grid.data).unwrap();
        let oracle = std_side::CostMap::with_params(grid, params).unwrap();
        let expected = oracle
            .footprint_cost(std_side::Pose2D::default(), &polygon)
            .unwrap();
        let got = map.footprint_cost(Pose2D::default(), &polygon).unwrap();
        assert_eq!((got.cost, got.leaves_map), (expected.cost, expected.leaves_map));
        assert_eq!(got.cost, Some(0), "cell ({gx}, {gy}) lies beside the polygon");
    }
}
