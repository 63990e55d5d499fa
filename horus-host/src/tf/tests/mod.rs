mod insert;
mod lookup;

use std::f64::consts::{FRAC_PI_2, PI};

use super::{Pose2, TfBuffer, TfError, Transform};

fn buffer(edges: &[(&str, &str, u64, Transform, bool)]) -> TfBuffer {
    let mut buffer = TfBuffer::new();
    for &(parent, child, stamp_ns, transform, is_static) in edges {
        buffer
            .insert(parent, child, stamp_ns, transform, is_static)
            .unwrap();
    }
    buffer
}

fn moving(samples: &[(u64, Transform)]) -> TfBuffer {
    let mut buffer = TfBuffer::new();
    for &(stamp_ns, transform) in samples {
        buffer.insert("odom", "base", stamp_ns, transform, false).unwrap();
    }
    buffer
}

#[track_caller]
fn assert_pose(pose: Result<Pose2, TfError>, x: f64, y: f64, yaw: f64) {
    let pose = pose.unwrap();
    let turn = libm::remainder(pose.yaw - yaw, 2.0 * PI);
    let error = (pose.x - x).abs().max((pose.y - y).abs()).max(turn.abs());
    assert!(error < 1e-9, "{pose:?} is not ({x}, {y}, {yaw})");
}

/// The tree of a robot with two sensors; everything but odom -> base is static.
fn robot() -> TfBuffer {
    buffer(&[
        ("map", "odom", 0, Transform::planar(10.0, 0.0, FRAC_PI_2), true),
        ("odom", "base", 100, Transform::planar(1.0, 2.0, 0.0), false),
        ("odom", "base", 200, Transform::planar(3.0, 2.0, FRAC_PI_2), false),
        ("base", "laser", 0, Transform::planar(0.2, 0.0, 0.0), true),
        ("base", "sonar", 0, Transform::planar(0.0, 0.1, PI), true),
    ])
}
