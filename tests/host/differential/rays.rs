//! Cell walks and rays against the std version, and walks against what they mean geometrically.

use horus_core::grid::OccupancyGrid2d;
use horus_core::nalgebra::{Isometry2, UnitComplex, Vector2};
use horus_core::prelude::*;
use horus_core::raycast::{CellWalk, RayCaster, WalkRule};
use horus_host::reference::{
    self, BelugaGrid, Values, Walk, standard_walk, supercover_walk, walk_cell, walk_steps,
};
use proptest::prelude::*;

const RULES: [(WalkRule, Walk); 3] = [
    (WalkRule::Standard, Walk::Standard),
    (WalkRule::Supercover, Walk::Supercover),
    (WalkRule::Navground, Walk::Navground),
];

fn walk(from: [i32; 2], to: [i32; 2], rule: WalkRule) -> Vec<[i32; 2]> {
    CellWalk::new(from.into(), to.into(), rule)
        .map(Into::into)
        .collect()
}

fn expected(from: [i32; 2], to: [i32; 2], rule: WalkRule) -> Vec<[i32; 2]> {
    match rule {
        WalkRule::Standard => standard_walk(from, to),
        WalkRule::Supercover => supercover_walk(from, to),
        WalkRule::Navground => {
            let steps = 0..=walk_steps(from, to);
            steps
                .map(|step| walk_cell(from, to, step).map(|c| c as i32))
                .collect()
        }
    }
}

#[test]
fn walks_mean_what_they_should() {
    let range = -13i64..=13;
    for (dx, dy) in range.clone().flat_map(|dx| range.clone().map(move |dy| (dx, dy))) {
        let to = [dx as i32, dy as i32];
        let n = dx.abs().max(dy.abs());
        for rule in [WalkRule::Standard, WalkRule::Navground] {
            let cells = walk([0, 0], to, rule);
            assert_eq!(cells.len() as i64, n + 1);
            for (i, cell) in cells.iter().enumerate() {
                // Twice the distance from the line, along the minor axis, in cells times n.
                let (major, minor, m) = if dx.abs() >= dy.abs() {
                    (cell[0], cell[1], dy)
                } else {
                    (cell[1], cell[0], dx)
                };
                assert_eq!(i64::from(major).abs(), i as i64);
                let ahead = 2 * (i64::from(minor) * n - i as i64 * m) * m.signum();
                let tie = if rule == WalkRule::Standard { -n } else { n };
                assert!(ahead.abs() < n || ahead == tie, "{to:?} {rule:?} {cell:?}");
            }
        }
        // A supercover holds each cell whose square, border included, meets the line; none twice; neighbours only.
        let mut cells = walk([0, 0], to, WalkRule::Supercover);
        for pair in cells.windows(2) {
            let step = [0, 1].map(|axis| pair[0][axis].abs_diff(pair[1][axis]));
            assert!(step.iter().all(|s| *s <= 1), "{to:?} {pair:?}");
        }
        let span = |d: i64| d.min(0)..=d.max(0);
        let touched = span(dx).flat_map(|x| span(dy).map(move |y| (x, y)));
        let touched = touched.filter(|(x, y)| 2 * (x * dy - y * dx).abs() <= dx.abs() + dy.abs());
        let mut touched: Vec<_> = touched.map(|(x, y)| [x as i32, y as i32]).collect();
        cells.sort_unstable();
        touched.sort_unstable();
        assert_eq!(cells, touched, "{to:?}");
    }
}

#[test]
fn walks_across_the_whole_range() {
    let far = [i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX - 1, i32::MAX];
    for (a, b) in far.into_iter().flat_map(|a| far.map(|b| (a, b))) {
        for (rule, _) in RULES {
            let mut cells = CellWalk::new(Vector2::new(a, 3), Vector2::new(b, -7), rule);
            let steps = (i64::from(a) - i64::from(b)).unsigned_abs().max(10);
            assert_eq!(cells.size_hint().0 as u64, steps + 1);
            let start: Vec<_> = cells.by_ref().take(40).map(Into::into).collect();
            let (n, m) = (i64::from(b) - i64::from(a), -10i64);
            let on_line = |c: &[i32; 2]| {
                let (x, y) = (i64::from(c[0]) - i64::from(a), i64::from(c[1]) - 3);
                2 * (i128::from(x) * i128::from(m) - i128::from(y) * i128::from(n)).abs()
                    <= i128::from(n.abs() + m.abs())
            };
            assert!(
                start[0] == [a, 3] && start.iter().all(on_line),
                "{a} {b} {rule:?}"
            );
        }
    }
}

fn end() -> impl Strategy<Value = [i32; 2]> {
    let near = -60i32..60;
    [near.clone(), near].prop_map(|c| c)
}

#[derive(Clone, Debug)]
struct Scene {
    width: u32,
    resolution: f32,
    origin: Pose2D,
    cells: Vec<i8>,
}

fn scene() -> impl Strategy<Value = Scene> {
    let place = (-5.0f32..5.0, -5.0f32..5.0, -4.0f32..4.0).prop_map(|(x, y, a)| Pose2D::new(x, y, a));
    let cell = prop_oneof![40 => Just(0i8), 1 => Just(100i8), 1 => Just(-1i8), 1 => Just(49i8)];
    ((1u32..30, 1u32..30), 0.02f32..0.6, place).prop_flat_map(move |((width, height), resolution, origin)| {
        let cells = prop::collection::vec(cell.clone(), (width * height) as usize);
        cells.prop_map(move |cells| Scene {
            width,
            resolution,
            origin,
            cells,
        })
    })
}

fn coordinate() -> impl Strategy<Value = f32> {
    prop_oneof![
        60 => -1.0f32..1.0,
        1 => Just(f32::NAN),
        1 => Just(f32::INFINITY),
        1 => any::<f32>(),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn walks_equal_the_std_version(from in end(), to in end()) {
        for (rule, _) in RULES {
            let cells = walk(from, to, rule);
            assert_eq!(cells, expected(from, to, rule));
            let (least, most) = CellWalk::new(from.into(), to.into(), rule).size_hint();
            assert!(least <= cells.len() && cells.len() <= most.unwrap());
        }
    }

    #[test]
    fn rays_equal_the_std_version(
        scene in scene(),
        pose in (coordinate(), coordinate(), coordinate()),
        bearing in coordinate(),
        range in prop_oneof![0.0f32..3.0, 0.0f32..1e4, any::<f32>()],
    ) {
        let Scene { width, resolution, origin, cells } = &scene;
        let height = cells.len() as u32 / width;
        let mut oracle = reference::OccupancyGrid::new(
            *width,
            height,
            *resolution,
            reference::Pose2D::new(origin.x.into(), origin.y.into(), origin.theta.into()),
        );
        oracle.data.clone_from(cells);
        let grid = OccupancyGrid::view(cells, *width, height, *resolution, *origin).unwrap();
        // Poses around the middle of the map, mostly inside.
        let side = resolution * (*width).max(height) as f32 * 0.6;
        let centre = Vector2::new(*width as f32, height as f32) * (0.5 * resolution);
        let at = grid.global_from_local(centre + Vector2::new(pose.0 * side, pose.1 * side));
        let (theta, bearing) = (4.0 * pose.2, 4.0 * bearing);
        let beluga = BelugaGrid { grid: &oracle, values: Values::Horus };
        for (rule, walk) in RULES {
            let from = reference::Pose2D::new(at.x.into(), at.y.into(), theta.into());
            // The std version walks the whole ray.
            let range = if range.abs() / resolution < 1e5 { range } else { f32::INFINITY };
            let rays = RayCaster::new(&grid, Isometry2::new(at, theta), range, rule);
            let trace: Vec<[i32; 2]> = rays.trace(UnitComplex::new(bearing)).map(Into::into).collect();
            assert_eq!(trace, beluga.trace(from, bearing.into(), range, walk), "{rule:?}");
            let expected = beluga.cast(from, bearing.into(), range, walk);
            let cast = rays.cast(UnitComplex::new(bearing));
            assert_eq!(cast.is_some(), expected.is_some(), "{rule:?}");
            if let Some((cast, expected)) = cast.zip(expected) {
                assert!((f64::from(cast) - expected).abs() <= 1e-6 * expected.abs(), "{cast} {expected}");
            }
        }
    }
}

#[test]
fn far_rays_end_at_the_map() {
    let cells = vec![0; 100];
    let grid = OccupancyGrid::view(&cells, 10, 10, 0.1, Pose2D::default()).unwrap();
    let pose = Isometry2::new(Vector2::new(0.55, 0.55), 0.3);
    for (rule, _) in RULES {
        // 10^9 cells; and more than 2^30 of them, where there is no ray.
        let trace = |range| {
            RayCaster::new(&grid, pose, range, rule)
                .trace(UnitComplex::identity())
                .count()
        };
        assert!((5..15).contains(&trace(1e8)), "{rule:?}");
        assert_eq!(trace(2e8), 0);
        assert_eq!(
            RayCaster::new(&grid, pose, 1e8, rule).cast(UnitComplex::identity()),
            None
        );
    }
}
