use std::f32::consts::{FRAC_PI_2, PI};

use super::super::{LaserScan, OccupancyGrid, Pose2D, Rect, ReferenceError, ScanModel, ScanReport};
use super::{Numbers, picture};

/// Beams along +x, +y, -x, -y.
fn scan(ranges: &[f32]) -> LaserScan {
    LaserScan {
        angle_min: 0.0,
        angle_increment: FRAC_PI_2,
        range_min: 0.1,
        range_max: 4.0,
        ranges: ranges.to_vec(),
    }
}

fn unknown() -> OccupancyGrid {
    picture(&["?????"; 5])
}

const MIDDLE: Pose2D = Pose2D::new(2.5, 2.5, 0.0);

#[test]
fn a_hit_clears_up_to_its_cell_and_a_miss_its_end_too() {
    let mut grid = unknown();
    let beams = scan(&[2.0, f32::INFINITY, f32::NAN, 4.0]);
    let report = grid.integrate_scan(&beams, MIDDLE, ScanModel::Set).unwrap();
    let expected = picture(&[
        "??.??", //
        "??.??", "??..#", "??.??", "??.??",
    ]);
    assert_eq!(grid.data, expected.data);
    let changed = Rect {
        x0: 2,
        y0: 0,
        x1: 5,
        y1: 5,
    };
    let report_of = |changed| ScanReport {
        changed,
        hits: 1,
        misses: 2,
        ignored: 1,
    };
    assert_eq!(report, report_of(Some(changed)));
    let again = grid.integrate_scan(&beams, MIDDLE, ScanModel::Set);
    assert_eq!(again, Ok(report_of(None)));
}

#[test]
fn ranges_follow_rep_117() {
    let beams = scan(&[0.0, 0.05, -1.0, f32::NEG_INFINITY, f32::NAN, 0.1, 3.999, 4.0, 9.0]);
    let report = unknown().integrate_scan(&beams, MIDDLE, ScanModel::Set).unwrap();
    assert_eq!((report.hits, report.misses, report.ignored), (2, 2, 5));
}

#[test]
fn a_hit_outlives_a_neighbour_beam_through_it() {
    let mut grid = picture(&["???"]);
    let mut beams = scan(&[1.2, f32::INFINITY, 0.6]);
    beams.angle_increment = 0.0;
    let pose = Pose2D::new(0.5, 0.5, 0.0);
    grid.integrate_scan(&beams, pose, ScanModel::Set).unwrap();
    assert_eq!(grid.data, [0, 100, 0]);
}

#[test]
fn yaw_turns_the_scan_and_theta_the_grid() {
    let mut turned = unknown();
    let pose = Pose2D {
        theta: f64::from(FRAC_PI_2),
        ..MIDDLE
    };
    turned
        .integrate_scan(&scan(&[1.0]), pose, ScanModel::Set)
        .unwrap();
    assert_eq!(
        (turned.occupancy(2, 2), turned.occupancy(2, 3)),
        (Some(0), Some(100))
    );

    let origin = Pose2D::new(5.0, 0.0, f64::from(FRAC_PI_2));
    let mut grid = OccupancyGrid::new(5, 5, 1.0, origin);
    grid.integrate_scan(&scan(&[1.0]), MIDDLE, ScanModel::Set)
        .unwrap();
    assert_eq!((grid.occupancy(2, 2), grid.occupancy(2, 1)), (Some(0), Some(100)));
    assert!(grid.is_occupied(3.5, 2.5));
}

#[test]
fn accumulating_takes_one_step_per_cell_and_scan() {
    let mut grid = picture(&["?3?9."]);
    let pose = Pose2D::new(0.5, 0.5, 0.0);
    let mut beams = scan(&[3.0, 3.0, 3.0]);
    beams.angle_increment = 0.0;
    let model = ScanModel::accumulate();
    let report = grid.integrate_scan(&beams, pose, model).unwrap();
    assert_eq!(grid.data, [43, 23, 43, 100, 0]);
    assert_eq!(
        report.changed,
        Some(Rect {
            x0: 0,
            y0: 0,
            x1: 4,
            y1: 1
        })
    );
    for _ in 0..4 {
        grid.integrate_scan(&beams, pose, model).unwrap();
    }
    assert_eq!(grid.data, [15, 0, 15, 100, 0]);
    let limited = ScanModel::Accumulate {
        hit: 127,
        miss: -128,
        min: 10,
        max: 90,
    };
    grid.integrate_scan(&beams, pose, limited).unwrap();
    assert_eq!(grid.data, [10, 10, 10, 90, 0]);
}

/// The cells a beam takes must not depend on the window they are seen through.
#[test]
fn a_small_window_sees_what_a_large_one_sees() {
    let mut numbers = Numbers(11);
    for _ in 0..50 {
        let origin = Pose2D::new(numbers.between(-1.0, 1.0), 0.3, numbers.between(-3.0, 3.0));
        let mut large = OccupancyGrid::new(120, 120, 0.1, origin);
        let mut small = OccupancyGrid::new(20, 30, 0.1, origin);
        let near = |n: &mut Numbers| n.between(-3.0, 3.0);
        let sensor = Pose2D::new(near(&mut numbers), near(&mut numbers), near(&mut numbers));
        large.recenter(sensor).unwrap();
        let elsewhere = Pose2D::new(near(&mut numbers), near(&mut numbers), 0.0);
        small.recenter(elsewhere).unwrap();
        let beams = LaserScan {
            angle_min: -PI,
            angle_increment: 0.05,
            range_min: 0.1,
            range_max: 4.0,
            ranges: (0..125).map(|_| numbers.between(0.0, 5.0) as f32).collect(),
        };
        let seen =
            [&mut large, &mut small].map(|g| g.integrate_scan(&beams, sensor, ScanModel::Set).unwrap());
        let counts = seen.map(|r| (r.hits, r.misses, r.ignored));
        assert_eq!(counts[0], counts[1]);
        let [dx, dy] = [0, 1].map(|a| small.offset()[a] - large.offset()[a]);
        for (gx, gy) in (0..20).flat_map(|gx| (0..30).map(move |gy| (gx, gy))) {
            let (lx, ly) = (gx as i32 + dx, gy as i32 + dy);
            let value = large.occupancy(lx as u32, ly as u32).unwrap_or(-1);
            assert_eq!(small.occupancy(gx, gy), Some(value));
        }
    }
}

#[test]
fn a_sensor_outside_the_map_still_draws_into_it() {
    let mut grid = picture(&["???"]);
    let pose = Pose2D::new(-1.5, 0.5, 0.0);
    let report = grid.integrate_scan(&scan(&[3.0]), pose, ScanModel::Set).unwrap();
    assert_eq!((grid.data, report.hits), (vec![0, 100, -1], 1));
}

#[test]
fn beams_that_end_nowhere_are_counted() {
    let all_ignored = ScanReport {
        ignored: 2,
        ..ScanReport::default()
    };
    let mut beams = scan(&[f32::INFINITY, f32::INFINITY]);
    for range_max in [f32::INFINITY, f32::MAX, 2e9] {
        beams.range_max = range_max;
        let report = unknown().integrate_scan(&beams, MIDDLE, ScanModel::Set);
        assert_eq!(report, Ok(all_ignored), "range_max {range_max}");
    }
    beams.range_max = 4.0;
    let far = unknown().integrate_scan(&beams, Pose2D::new(1e12, 2.5, 0.0), ScanModel::Set);
    assert_eq!(far, Ok(all_ignored));
    for (x, theta) in [(f64::NAN, 0.0), (1e300, 0.0), (2.5, f64::INFINITY)] {
        let pose = Pose2D::new(x, 2.5, theta);
        let report = unknown().integrate_scan(&beams, pose, ScanModel::Set);
        assert_eq!(
            report,
            Err(ReferenceError::Pose("sensor pose")),
            "sensor at {pose:?}"
        );
    }
    // Half the range of cell numbers is still drawn.
    beams.range_max = 1e9;
    let mut grid = unknown();
    let report = grid.integrate_scan(&beams, MIDDLE, ScanModel::Set).unwrap();
    assert_eq!(report.misses, 2);
    assert_eq!((grid.occupancy(4, 2), grid.occupancy(2, 4)), (Some(0), Some(0)));
}

#[test]
fn bad_scans_and_models_change_nothing() {
    let mut grid = unknown();
    let nan = [
        (
            "angle_min",
            LaserScan {
                angle_min: f32::NAN,
                ..scan(&[1.0])
            },
        ),
        (
            "angle_increment",
            LaserScan {
                angle_increment: f32::NAN,
                ..scan(&[1.0])
            },
        ),
        (
            "range_min",
            LaserScan {
                range_min: f32::NAN,
                ..scan(&[1.0])
            },
        ),
        (
            "range_max",
            LaserScan {
                range_max: f32::NAN,
                ..scan(&[1.0])
            },
        ),
    ];
    for (field, beams) in nan {
        let refused = grid.integrate_scan(&beams, MIDDLE, ScanModel::Set);
        assert_eq!(refused, Err(ReferenceError::Scan(field)));
    }
    for (hit, miss, min, max) in [
        (-1, 0, 0, 9),
        (1, 1, 0, 9),
        (1, 0, -1, 9),
        (1, 0, 9, 8),
        (1, 0, 0, 101),
    ] {
        let model = ScanModel::Accumulate { hit, miss, min, max };
        let refused = grid.integrate_scan(&scan(&[1.0]), MIDDLE, model);
        assert_eq!(refused, Err(ReferenceError::ScanModel { hit, miss, min, max }));
    }
    assert_eq!(grid, unknown());
}

/// Where beams end, against plain trigonometry in f64.
#[test]
fn hits_lie_where_the_sensor_saw_them() {
    let mut numbers = Numbers(23);
    for _ in 0..500 {
        let mut grid = OccupancyGrid::new(200, 200, 0.05, Pose2D::new(-5.0, -5.0, 0.0));
        let mut angle = || numbers.between(-3.0, 3.0);
        let (yaw, angle_min, angle_increment) = (angle(), angle() as f32, angle() as f32);
        let (x, y) = (numbers.between(-1.0, 1.0), numbers.between(-1.0, 1.0));
        let ranges = [0.5, 1.0, 1.5, 2.0, 2.5, 3.0];
        let beams = LaserScan {
            angle_min,
            angle_increment,
            ..scan(&ranges)
        };
        let pose = Pose2D::new(x, y, yaw);
        grid.integrate_scan(&beams, pose, ScanModel::Set).unwrap();
        for (i, &range) in ranges.iter().enumerate() {
            let angle = yaw + f64::from(angle_min) + i as f64 * f64::from(angle_increment);
            let (hx, hy) = (
                x + angle.cos() * f64::from(range),
                y + angle.sin() * f64::from(range),
            );
            let q = [hx, hy].map(|v| (v + 5.0) / 0.05);
            if q.iter().all(|q| (q - q.round()).abs() > 2e-3) {
                assert!(grid.is_occupied(hx, hy), "beam {i} of {beams:?} from {pose:?}");
            }
        }
    }
}
