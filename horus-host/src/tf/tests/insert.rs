use super::super::{TfBuffer, TfError, Transform};
use super::{assert_pose, buffer, moving, robot};

#[test]
fn leading_slashes_do_not_matter() {
    let buffer = buffer(&[("/odom", "//base", 0, Transform::planar(1.0, 0.0, 0.0), true)]);
    assert_pose(buffer.lookup("odom", "/base", 0), 1.0, 0.0, 0.0);
    assert_eq!(
        TfBuffer::new().lookup("/", "a", 0),
        Err(TfError::InvalidName {
            length: 0,
            longest: 255
        })
    );
}

#[test]
fn bad_transforms_leave_the_buffer_unchanged() {
    let good = Transform::IDENTITY;
    let with = |index: usize, value: f64| {
        let mut bad = good;
        if index < 3 {
            bad.translation[index] = value;
        } else {
            bad.rotation[index - 3] = value;
        }
        bad
    };
    let mut buffer = TfBuffer::new();
    for index in 0..7 {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(matches!(
                buffer.insert("a", "b", 0, with(index, value), false),
                Err(TfError::NotFinite { .. })
            ));
        }
    }
    for w in [0.0, -0.0, 1e-300] {
        assert!(matches!(
            buffer.insert("a", "b", 0, with(6, w), true),
            Err(TfError::ZeroQuaternion { .. })
        ));
    }
    assert!(matches!(
        buffer.insert("/a", "a", 0, good, true),
        Err(TfError::OwnParent { .. })
    ));
    for name in ["", "///", &"n".repeat(256)] {
        assert!(matches!(
            buffer.insert("a", name, 0, good, true),
            Err(TfError::InvalidName { .. })
        ));
    }
    assert!(buffer.is_empty());
    assert!(matches!(
        buffer.lookup("a", "b", 0),
        Err(TfError::UnknownFrame { .. })
    ));
}

#[test]
fn a_frame_stays_static_or_moving() {
    let mut robot = robot();
    assert_eq!(
        robot.insert("base", "laser", 5, Transform::IDENTITY, false),
        Err(TfError::KindChanged {
            child: "laser".into(),
            was_static: true
        })
    );
    let moved = robot
        .insert("odom", "base", 5, Transform::IDENTITY, true)
        .unwrap_err();
    assert_eq!(
        moved.to_string(),
        "frame `base` was moving before and cannot become static"
    );
    assert_pose(robot.lookup("base", "laser", 5), 0.2, 0.0, 0.0);
}

#[test]
fn a_full_buffer_refuses_new_transforms_and_still_replaces_old_ones() {
    let mut buffer = TfBuffer::with_capacity(2);
    let (one, two) = (Transform::planar(1.0, 0.0, 0.0), Transform::planar(2.0, 0.0, 0.0));
    buffer.insert("a", "b", 0, one, false).unwrap();
    buffer.insert("b", "c", 0, one, true).unwrap();
    assert_eq!(
        buffer.insert("a", "b", 1, one, false),
        Err(TfError::Full { capacity: 2 })
    );
    assert_eq!(
        buffer.insert("a", "d", 1, one, true),
        Err(TfError::Full { capacity: 2 })
    );
    buffer.insert("a", "b", 0, two, false).unwrap();
    buffer.insert("b", "c", 9, two, true).unwrap();
    assert_eq!(buffer.len(), 2);
    assert_pose(buffer.lookup("a", "c", 0), 4.0, 0.0, 0.0);
}

#[test]
fn quaternions_are_normalised_whatever_their_size() {
    for scale in [1e-5, 3.0, 1e300] {
        let mut turned = Transform::planar(0.0, 0.0, 1.0);
        turned.rotation = turned.rotation.map(|q| q * scale);
        let turned = moving(&[(0, turned)]);
        assert_pose(turned.lookup("odom", "base", 0), 0.0, 0.0, 1.0);
    }
}
