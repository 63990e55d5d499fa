use super::super::{OccupancyGrid, Pose2D, ReferenceError};
use super::{Numbers, picture};

#[test]
fn cells_keep_their_place_in_the_world() {
    let mut numbers = Numbers(3);
    let mut grid = OccupancyGrid::new(30, 20, 0.1, Pose2D::new(-1.0, 4.0, 0.6));
    grid.recenter(Pose2D::new(0.0, 5.0, 0.0)).unwrap();
    for _ in 0..200 {
        for value in &mut grid.data {
            *value = numbers.below(101) as i8;
        }
        let before = grid.clone();
        let (dx, dy) = (numbers.between(-1.0, 1.0), numbers.between(-1.0, 1.0));
        let (cx, cy) = grid.grid_to_world(15, 10).unwrap();
        let pose = Pose2D::new(cx + dx, cy + dy, 0.0);
        let shift = grid.recenter(pose).unwrap();
        let [x0, y0] = before.offset();
        assert_eq!(grid.offset(), [x0 + shift.0, y0 + shift.1]);
        for (gx, gy) in (0..30).flat_map(|gx| (0..20).map(move |gy| (gx, gy))) {
            let (x, y) = grid.grid_to_world(gx, gy).unwrap();
            let old = before
                .world_to_grid(x, y)
                .and_then(|(gx, gy)| before.occupancy(gx, gy));
            assert_eq!(grid.occupancy(gx, gy), Some(old.unwrap_or(-1)));
        }
        let (gx, gy) = grid.world_to_grid(pose.x, pose.y).unwrap();
        assert!((14..=15).contains(&gx) && (9..=10).contains(&gy));
        // The displayed origin is the corner of cell (0, 0).
        let corner = grid.corner_plus(0.0, 0.0);
        assert_eq!(
            (grid.origin.x, grid.origin.y, grid.origin.theta),
            (corner.0, corner.1, 0.6)
        );
        assert_eq!(grid.world_to_grid(corner.0, corner.1), Some((0, 0)));
    }
}

#[test]
fn half_a_cell_shifts_to_the_even_side() {
    let mut grid = OccupancyGrid::new(4, 4, 1.0, Pose2D::default());
    assert_eq!(grid.recenter(Pose2D::new(2.5, 3.5, 0.0)), Ok((0, 2)));
    assert_eq!(grid.recenter(Pose2D::new(0.5, 4.5, 0.0)), Ok((-2, 0)));
}

#[test]
fn a_far_jump_clears_all_and_a_zero_shift_nothing() {
    let mut grid = picture(&["#.", ".#"]);
    let before = grid.clone();
    assert_eq!(grid.recenter(Pose2D::new(1.2, 0.8, 3.0)), Ok((0, 0)));
    assert_eq!(grid, before);
    assert_eq!(grid.recenter(Pose2D::new(2.0, 1.0, 0.0)), Ok((1, 0)));
    assert_eq!(grid.data, [100, -1, 0, -1]);
    assert_eq!(grid.recenter(Pose2D::new(1e6, 1.0, 0.0)), Ok((999_998, 0)));
    assert_eq!(grid.data, [-1; 4]);
    assert_eq!(grid.recenter(Pose2D::new(1.0, 1.0, 0.0)), Ok((-999_999, 0)));
    assert_eq!(grid.origin, Pose2D::default());
}

#[test]
fn a_window_that_cannot_move_stays() {
    let mut grid = picture(&["#.", ".#"]);
    let before = grid.clone();
    for (x, y, theta) in [
        (f64::NAN, 0.0, 0.0),
        (0.0, f64::NEG_INFINITY, 0.0),
        (0.0, 0.0, f64::NAN),
        (1e300, 0.0, 0.0),
    ] {
        let refused = grid.recenter(Pose2D::new(x, y, theta));
        assert_eq!(refused, Err(ReferenceError::Pose("pose to recenter on")));
    }
    for far in [1.2e9, -1.2e9, 1e38] {
        let refused = grid.recenter(Pose2D::new(0.0, far, 0.0));
        assert_eq!(refused, Err(ReferenceError::WindowOffset));
    }
    assert_eq!(grid, before);
}
