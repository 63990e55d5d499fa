use super::super::{CostMap, CostParams, FootprintCost, OccupancyGrid, Pose2D, ReferenceError};
use super::picture;

/// Costs without inflation: 20 times a digit of the picture, 253 for `#`, 255 for `?`.
fn map(rows: &[&str]) -> CostMap {
    let params = CostParams {
        inflation_radius: 0.0,
        ..CostParams::default()
    };
    CostMap::with_params(picture(rows), params).unwrap()
}

fn known(cost: u8) -> FootprintCost {
    FootprintCost {
        cost: Some(cost),
        touches_unknown: false,
        leaves_map: false,
    }
}

const SQUARE: [(f32, f32); 4] = [(1.2, 1.2), (-1.2, 1.2), (-1.2, -1.2), (1.2, -1.2)];
const MIDDLE: Pose2D = Pose2D::new(2.5, 2.5, 0.0);

#[test]
fn the_highest_cost_under_the_polygon_counts() {
    let map = map(&[
        "#####", //
        "#1..#", "#.2.#", "#...#", "#####",
    ]);
    // The square's vertices lie in the cells around (2, 2): only its inside and edges count.
    assert_eq!(map.footprint_cost(MIDDLE, &SQUARE), Ok(known(40)));
    let up = Pose2D { y: 3.5, ..MIDDLE };
    assert_eq!(map.footprint_cost(up, &SQUARE), Ok(known(253)));
    let turned = Pose2D {
        theta: std::f64::consts::FRAC_PI_4,
        ..MIDDLE
    };
    assert_eq!(map.footprint_cost(turned, &SQUARE), Ok(known(253)));
}

#[test]
fn edges_cover_the_cells_they_walk_through() {
    let map = map(&[
        "4....", //
        ".3...", "..2..", "...1.", ".....",
    ]);
    // A sliver: no cell centre is inside it.
    let sliver = [(-2.3, 2.2), (-2.2, 2.3), (2.3, -2.3)];
    assert_eq!(map.footprint_cost(MIDDLE, &sliver), Ok(known(80)));
    let short = [(0.3, 0.2), (0.2, 0.3), (1.3, -1.3)];
    assert_eq!(map.footprint_cost(MIDDLE, &short), Ok(known(40)));
}

#[test]
fn even_odd_leaves_the_middle_of_a_star_out() {
    let map = map(&["........."; 9]);
    let mut map = map;
    map.occupancy_grid.set_occupancy(4, 4, 100);
    map.compute_costs();
    let corner = |i: u32| {
        let angle = std::f32::consts::TAU * (i * 2 % 5) as f32 / 5.0;
        (4.0 * angle.cos(), 4.0 * angle.sin())
    };
    let star = [0, 1, 2, 3, 4].map(corner);
    let at = Pose2D::new(4.5, 4.5, 0.0);
    assert_eq!(map.footprint_cost(at, &star), Ok(known(0)));
    let pentagon = [0, 3, 1, 4, 2].map(corner);
    assert_eq!(map.footprint_cost(at, &pentagon), Ok(known(253)));
}

#[test]
fn unknown_hides_nothing() {
    let rows = [
        ".....", //
        ".?.#.", ".....", ".....", ".....",
    ];
    let both = FootprintCost {
        cost: Some(253),
        touches_unknown: true,
        leaves_map: false,
    };
    assert_eq!(map(&rows).footprint_cost(MIDDLE, &SQUARE), Ok(both));
    let none = FootprintCost {
        cost: None,
        touches_unknown: true,
        leaves_map: false,
    };
    assert_eq!(map(&["?????"; 5]).footprint_cost(MIDDLE, &SQUARE), Ok(none));
}

#[test]
fn leaving_the_map_is_said() {
    let map = map(&["1....", ".....", "....."]);
    let over_the_edge = Pose2D::new(0.5, 2.5, 0.0);
    let leaves = FootprintCost {
        leaves_map: true,
        ..known(20)
    };
    assert_eq!(map.footprint_cost(over_the_edge, &SQUARE), Ok(leaves));
    let far = Pose2D::new(-50.0, 2.5, 0.0);
    let nothing = FootprintCost { cost: None, ..leaves };
    assert_eq!(map.footprint_cost(far, &SQUARE), Ok(nothing));
    // All vertices outside, the map inside.
    let around = SQUARE.map(|(x, y)| (x * 100.0, y * 100.0));
    assert_eq!(map.footprint_cost(MIDDLE, &around), Ok(leaves));
    assert_eq!(CostMap::default().footprint_cost(MIDDLE, &SQUARE), Ok(nothing));
}

#[test]
fn a_moved_and_turned_window_answers_the_same() {
    let mut grid = OccupancyGrid::new(40, 40, 0.1, Pose2D::new(3.0, -2.0, 0.9));
    let robot = Pose2D::new(7.0, 7.0, -0.4);
    grid.recenter(robot).unwrap();
    grid.data.fill(0);
    let (gx, gy) = grid.world_to_grid(7.45, 6.85).unwrap();
    grid.set_occupancy(gx, gy, 100);
    let map = CostMap::from_occupancy_grid(grid, 0.0);
    let body = |half: f32| [(half, half), (-half, half), (-half, -half), (half, -half)];
    assert_eq!(map.footprint_cost(robot, &body(0.6)), Ok(known(253)));
    assert_eq!(map.footprint_cost(robot, &body(0.2)), Ok(known(0)));
}

#[test]
fn bad_polygons_and_poses_are_errors() {
    let map = map(&["....."; 5]);
    let refused = |pose, polygon: &[(f32, f32)]| map.footprint_cost(pose, polygon).unwrap_err();
    assert_eq!(refused(MIDDLE, &SQUARE[..2]), ReferenceError::PolygonSize(2));
    assert_eq!(refused(MIDDLE, &[]), ReferenceError::PolygonSize(0));
    let mut polygon = SQUARE;
    polygon[1].0 = f32::NAN;
    assert_eq!(refused(MIDDLE, &polygon), ReferenceError::Vertex(1));
    for far in [2e9, f32::MAX] {
        polygon[1].0 = far;
        assert_eq!(refused(MIDDLE, &polygon), ReferenceError::VertexCell(1));
    }
    for pose in [
        Pose2D {
            theta: f64::NAN,
            ..MIDDLE
        },
        Pose2D {
            x: f64::INFINITY,
            ..MIDDLE
        },
        Pose2D { y: 1e300, ..MIDDLE },
    ] {
        assert_eq!(refused(pose, &SQUARE), ReferenceError::Pose("footprint's pose"));
    }
}
