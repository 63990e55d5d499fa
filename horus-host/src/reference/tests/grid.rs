use super::super::{OccupancyGrid, Pose2D, ReferenceError};
use super::Numbers;

#[test]
fn impossible_grids_are_errors() {
    let at = Pose2D::default();
    for resolution in [0.0, -0.1, f32::NAN, f32::INFINITY] {
        let refused = OccupancyGrid::try_new(2, 2, resolution, at);
        assert!(matches!(refused, Err(ReferenceError::Resolution(_))));
    }
    for origin in [
        Pose2D::new(f64::NAN, 0.0, 0.0),
        Pose2D::new(0.0, f64::INFINITY, 0.0),
        Pose2D::new(0.0, 0.0, f64::NAN),
        Pose2D::new(1e300, 0.0, 0.0),
    ] {
        let refused = OccupancyGrid::try_new(2, 2, 0.05, origin);
        assert_eq!(refused, Err(ReferenceError::Pose("grid's origin")));
    }
    for (width, height) in [(u32::MAX, u32::MAX), (u32::MAX, 0), (1 << 30, 1 << 30)] {
        let refused = OccupancyGrid::try_new(width, height, 0.05, at);
        assert_eq!(refused, Err(ReferenceError::GridSize { width, height }));
    }
}

#[test]
#[should_panic = "a grid's resolution must be finite and above zero, not 0 m per cell"]
fn new_panics_where_try_new_errs() {
    OccupancyGrid::new(2, 2, 0.0, Pose2D::default());
}

#[test]
fn a_grid_without_cells_has_nothing_inside() {
    let mut grid = OccupancyGrid::default();
    assert_eq!((grid.resolution, grid.data.len()), (0.05, 0));
    assert_eq!(grid.world_to_grid(0.0, 0.0), None);
    assert_eq!(grid.grid_to_world(0, 0), None);
    assert!(!grid.set_occupancy(0, 0, 1));
}

#[test]
fn unknown_and_outside_are_neither_free_nor_occupied() {
    let mut grid = OccupancyGrid::new(2, 1, 1.0, Pose2D::default());
    grid.set_occupancy(0, 0, 49);
    assert!(grid.is_free(0.5, 0.5) && !grid.is_occupied(0.5, 0.5));
    grid.set_occupancy(0, 0, 50);
    assert!(!grid.is_free(0.5, 0.5) && grid.is_occupied(0.5, 0.5));
    for (x, y) in [(1.5, 0.5), (2.5, 0.5), (-0.5, 0.5), (f64::NAN, 0.5)] {
        assert!(!grid.is_free(x, y) && !grid.is_occupied(x, y));
    }
}

#[test]
fn nominal_boundaries_belong_to_the_upper_cell_in_both_arithmetics() {
    for resolution in [0.01, 0.02, 0.025, 0.05, 0.1, 0.2, 0.25, 0.5] {
        for origin in [0.0, -5.0, 3.3, -102.0] {
            let pose = Pose2D::new(origin, origin, 0.0);
            let grid = OccupancyGrid::new(4096, 1, resolution as f32, pose);
            let frame = grid.frame();
            let y = origin + 0.5 * resolution;
            for k in 0..4096 {
                // The boundary as somebody would write it down.
                let x = ((origin + f64::from(k) * resolution) * 1e6).round() / 1e6;
                assert_eq!(grid.world_to_grid(x, y), Some((k, 0)), "{x} at {resolution}");
                let cell = frame.cell([x as f32, y as f32]);
                assert_eq!(cell, Some([k as i32, 0]), "{x} at {resolution}");
            }
            let far_edge = origin + 4096.0 * resolution;
            assert_eq!(grid.world_to_grid(far_edge, y), None);
        }
    }
}

#[test]
fn decisions_in_f32_differ_from_f64_near_boundaries_only() {
    let mut numbers = Numbers(7);
    for _ in 0..20_000 {
        let theta = numbers.between(-3.2, 3.2);
        let (x, y) = (numbers.between(-50.0, 50.0), numbers.between(-50.0, 50.0));
        let grid = OccupancyGrid::new(1000, 1000, 0.05, Pose2D::new(x, y, theta));
        let (gx, gy) = (numbers.between(0.0, 1000.0), numbers.between(0.0, 1000.0));
        let margin = (gx - gx.round()).abs().min((gy - gy.round()).abs());
        if margin < 2e-3 {
            continue;
        }
        let (px, py) = grid.corner_plus(gx, gy);
        let expected = (gx as u32, gy as u32);
        assert_eq!(grid.world_to_grid(px, py), Some(expected));
        let cell = grid.frame().cell([px as f32, py as f32]);
        assert_eq!(cell, Some([expected.0 as i32, expected.1 as i32]));
    }
}

#[test]
fn a_cell_centre_lies_in_its_cell_and_heading_turns_it() {
    let grid = OccupancyGrid::new(20, 10, 0.1, Pose2D::new(1.0, 2.0, std::f64::consts::FRAC_PI_2));
    let (x, y) = grid.grid_to_world(3, 0).unwrap();
    assert!((x - 0.95).abs() < 1e-6 && (y - 2.35).abs() < 1e-6);
    for (gx, gy) in (0..20).flat_map(|gx| (0..10).map(move |gy| (gx, gy))) {
        let (x, y) = grid.grid_to_world(gx, gy).unwrap();
        assert_eq!(grid.world_to_grid(x, y), Some((gx, gy)));
    }
    assert_eq!(grid.grid_to_world(20, 0), None);
    assert_eq!(grid.grid_to_world(0, 10), None);
}

#[test]
fn cells_missing_from_data_are_outside() {
    let mut grid = OccupancyGrid::new(2, 2, 1.0, Pose2D::default());
    grid.data.truncate(3);
    assert!(grid.set_occupancy(0, 1, 1) && !grid.set_occupancy(1, 1, 1));
    assert_eq!(grid.occupancy(1, 1), None);
}

#[test]
fn a_frame_name_is_cut_at_a_character() {
    let mut grid = OccupancyGrid::default();
    assert_eq!(grid.frame_id_str(), "");
    grid.set_frame_id("map");
    assert_eq!((grid.frame_id_str(), grid.frame_id[3]), ("map", 0));
    let long = format!("{}é", "m".repeat(31));
    grid.set_frame_id(&long);
    assert_eq!(grid.frame_id_str(), "m".repeat(31));
    grid.set_frame_id(&"m".repeat(40));
    assert_eq!(grid.frame_id_str(), "m".repeat(32));
    grid.frame_id[1] = 0xff;
    assert_eq!(grid.frame_id_str(), "m");
}
