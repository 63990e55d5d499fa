use std::f64::consts::{FRAC_PI_2, PI};

use proptest::prelude::*;

use super::super::{Pose2, TfBuffer, TfError, Transform};
use super::{assert_pose, buffer, moving, robot};

#[test]
fn chains_are_composed_upwards_downwards_and_across() {
    let robot = robot();
    assert_pose(robot.lookup("odom", "laser", 100), 1.2, 2.0, 0.0);
    assert_pose(robot.lookup("odom", "laser", 200), 3.0, 2.2, FRAC_PI_2);
    assert_pose(robot.lookup("map", "laser", 100), 8.0, 1.2, FRAC_PI_2);
    assert_pose(robot.lookup("laser", "odom", 100), -1.2, -2.0, 0.0);
    assert_pose(robot.lookup("laser", "sonar", 150), -0.2, 0.1, PI);
    assert_pose(robot.lookup("base", "base", 9), 0.0, 0.0, 0.0);
}

#[test]
fn static_edges_hold_at_any_time_and_edges_above_the_ancestor_do_not_matter() {
    let robot = robot();
    for stamp_ns in [0, 150, u64::MAX] {
        assert_pose(robot.lookup("base", "laser", stamp_ns), 0.2, 0.0, 0.0);
        assert_pose(robot.lookup("sonar", "laser", stamp_ns), -0.2, 0.1, PI);
    }
}

#[test]
fn moving_edges_are_interpolated() {
    let robot = robot();
    let quarter = FRAC_PI_2 / 4.0;
    assert_pose(robot.lookup("odom", "base", 125), 1.5, 2.0, quarter);
    assert_pose(robot.lookup("odom", "base", 175), 2.5, 2.0, 3.0 * quarter);
}

#[test]
fn rotation_takes_the_shorter_arc() {
    let across = moving(&[
        (0, Transform::planar(0.0, 0.0, 3.0)),
        (10, Transform::planar(0.0, 0.0, -3.0)),
    ]);
    assert_pose(across.lookup("odom", "base", 5), 0.0, 0.0, PI);

    let mut negated = Transform::planar(0.0, 0.0, 1.0);
    negated.rotation = negated.rotation.map(|q| -q);
    let same = moving(&[(0, Transform::planar(0.0, 0.0, 0.0)), (10, negated)]);
    assert_pose(same.lookup("odom", "base", 5), 0.0, 0.0, 0.5);

    let equal = Transform::planar(0.0, 0.0, 1.0);
    let still = moving(&[(0, equal), (10, equal)]);
    assert_pose(still.lookup("odom", "base", 5), 0.0, 0.0, 1.0);
}

#[test]
fn transforms_are_composed_in_space_before_they_are_seen_from_above() {
    // A laser mounted upside down on a base that is itself rolled by 180 degrees.
    let roll = Transform {
        translation: [0.0, 0.0, 1.0],
        rotation: [1.0, 0.0, 0.0, 0.0],
    };
    let mount = Transform {
        translation: [0.5, 0.5, 0.0],
        rotation: [0.0, 0.0, (FRAC_PI_2 / 2.0).sin(), (FRAC_PI_2 / 2.0).cos()],
    };
    let rolled = buffer(&[("map", "base", 0, roll, true), ("base", "laser", 0, mount, true)]);
    assert_pose(rolled.lookup("map", "laser", 0), 0.5, -0.5, -FRAC_PI_2);
    assert_eq!(
        rolled.lookup_transform("map", "laser", 0).unwrap().translation[2],
        1.0
    );
}

#[test]
fn an_x_axis_that_points_up_has_yaw_zero() {
    let half = (0.5_f64).sqrt();
    let up = Transform {
        translation: [1.0, 2.0, 3.0],
        rotation: [0.0, -half, 0.0, half],
    };
    let pose = up.to_planar();
    assert_eq!(
        pose,
        Pose2 {
            x: 1.0,
            y: 2.0,
            yaw: 0.0
        }
    );
}

#[test]
fn times_beyond_the_samples_are_refused() {
    let robot = robot();
    for stamp_ns in [99, 201] {
        assert_eq!(
            robot.lookup("map", "laser", stamp_ns),
            Err(TfError::Extrapolation {
                parent: "odom".into(),
                child: "base".into(),
                stamp_ns,
                oldest_ns: 100,
                newest_ns: 200,
            })
        );
    }
    let message = robot.lookup("odom", "base", 99).unwrap_err().to_string();
    assert_eq!(
        message,
        "the pose of `base` in `odom` at 99 ns would be extrapolated: it is known from 100 to 200 ns"
    );
}

#[test]
fn one_sample_answers_for_its_own_time_only() {
    let one = moving(&[(7, Transform::planar(1.0, 0.0, 0.0))]);
    assert_pose(one.lookup("odom", "base", 7), 1.0, 0.0, 0.0);
    assert!(one.lookup("odom", "base", 8).is_err());
}

#[test]
fn long_gaps_are_refused_if_asked() {
    let mut robot = robot();
    robot.set_max_gap_ns(Some(99));
    assert_eq!(
        robot.lookup("odom", "base", 150),
        Err(TfError::Gap {
            parent: "odom".into(),
            child: "base".into(),
            stamp_ns: 150,
            before_ns: 100,
            after_ns: 200,
            max_gap_ns: 99,
        })
    );
    assert!(robot.lookup("odom", "base", 100).is_ok());
    assert!(robot.lookup("odom", "base", 200).is_ok());
    robot.set_max_gap_ns(Some(100));
    assert!(robot.lookup("odom", "base", 150).is_ok());
}

#[test]
fn unknown_and_disconnected_frames_are_told_apart() {
    let mut robot = robot();
    let pose = Transform::IDENTITY;
    robot.insert("world", "crate", 0, pose, true).unwrap();
    assert_eq!(
        robot.lookup("map", "camera", 100),
        Err(TfError::UnknownFrame {
            frame: "camera".into()
        })
    );
    assert_eq!(
        robot.lookup("map", "crate", 100),
        Err(TfError::Disconnected {
            target: "map".into(),
            source_frame: "crate".into(),
            stamp_ns: 100,
        })
    );
}

#[test]
fn loops_end() {
    let pose = Transform::IDENTITY;
    let ring = buffer(&[
        ("a", "b", 0, pose, true),
        ("b", "c", 0, pose, true),
        ("c", "a", 0, pose, true),
        ("c", "tail", 0, pose, true),
    ]);
    for frame in ["a", "b", "c", "tail"] {
        assert!(matches!(
            ring.lookup(frame, "a", 5),
            Err(TfError::Loop { stamp_ns: 5, .. })
        ));
    }
}

#[test]
fn a_loop_of_parents_that_change_hands_exists_only_for_its_time() {
    let pose = Transform::planar(1.0, 0.0, 0.0);
    let swapped = buffer(&[
        ("a", "b", 0, pose, false),
        ("a", "b", 10, pose, false),
        ("b", "a", 20, pose, false),
        ("world", "b", 20, pose, false),
    ]);
    assert_pose(swapped.lookup("world", "a", 20), 2.0, 0.0, 0.0);
    assert!(matches!(swapped.lookup("a", "b", 5), Err(TfError::Loop { .. })));
}

#[test]
fn a_new_parent_counts_from_its_first_transform() {
    let pose = Transform::planar(1.0, 0.0, 0.0);
    let carried = buffer(&[
        ("shelf", "box", 10, pose, false),
        ("shelf", "box", 20, pose, false),
        ("robot", "box", 30, pose, false),
        ("robot", "box", 40, pose, false),
    ]);
    assert_pose(carried.lookup("shelf", "box", 15), 1.0, 0.0, 0.0);
    assert_pose(carried.lookup("robot", "box", 35), 1.0, 0.0, 0.0);
    assert!(matches!(
        carried.lookup("robot", "box", 15),
        Err(TfError::Disconnected { .. })
    ));
    assert_eq!(
        carried.lookup("shelf", "box", 25),
        Err(TfError::ParentChanged {
            child: "box".into(),
            before: "shelf".into(),
            after: "robot".into(),
            stamp_ns: 25,
        })
    );
}

#[test]
fn a_result_that_overflows_is_refused() {
    let far = Transform::planar(f64::MAX, 0.0, 0.0);
    let chain = buffer(&[("a", "b", 0, far, true), ("b", "c", 0, far, true)]);
    assert!(matches!(
        chain.lookup("a", "c", 0),
        Err(TfError::NotFinite { .. })
    ));
}

proptest! {
    #[test]
    fn planar_chains_agree_with_planar_arithmetic(
        steps in prop::collection::vec((-5.0..5.0_f64, -5.0..5.0_f64, -3.0..3.0_f64), 1..6)
    ) {
        let mut buffer = TfBuffer::new();
        let (mut x, mut y, mut yaw) = (0.0, 0.0, 0.0_f64);
        for (i, &(dx, dy, turn)) in steps.iter().enumerate() {
            let (parent, child) = (format!("f{i}"), format!("f{}", i + 1));
            buffer.insert(&parent, &child, 0, Transform::planar(dx, dy, turn), true).unwrap();
            x += yaw.cos() * dx - yaw.sin() * dy;
            y += yaw.sin() * dx + yaw.cos() * dy;
            yaw += turn;
        }
        let last = format!("f{}", steps.len());
        assert_pose(buffer.lookup("f0", &last, 0), x, y, yaw);
        let there = buffer.lookup_transform("f0", &last, 0).unwrap();
        let back = buffer.lookup_transform(&last, "f0", 0).unwrap();
        let mut round = TfBuffer::new();
        round.insert("a", "b", 0, there, true).unwrap();
        round.insert("b", "c", 0, back, true).unwrap();
        assert_pose(round.lookup("a", "c", 0), 0.0, 0.0, 0.0);
    }

    #[test]
    fn the_order_of_insertion_does_not_matter(
        stamps in prop::collection::btree_set(0..1000_u64, 2..20),
        at in 0..1000_u64,
    ) {
        let samples: Vec<_> = stamps
            .iter()
            .map(|&ns| (ns, Transform::planar(ns as f64, 0.0, ns as f64 * 0.01)))
            .collect();
        let forward = moving(&samples);
        let reversed: Vec<_> = samples.iter().rev().copied().collect();
        prop_assert_eq!(
            forward.lookup("odom", "base", at),
            moving(&reversed).lookup("odom", "base", at)
        );
        if let Ok(pose) = forward.lookup("odom", "base", at) {
            prop_assert!((pose.x - at as f64).abs() < 1e-9);
        }
    }
}
