//! What holds for any map.

use horus_core::local::{FREE, OCCUPIED, UNKNOWN};
use horus_core::prelude::*;
use proptest::prelude::*;

const RESOLUTION: f32 = 0.05;

fn config(lidars: &'static [Lidar<'static>]) -> LocalGridMapConfig<'static> {
    LocalGridMapConfig {
        width: 60,
        height: 50,
        resolution: RESOLUTION,
        footprint: Footprint::None,
        lidars,
        ..LocalGridMapConfig::default()
    }
}

const fn lidar(name: &'static str, start_angle: f32, fov: f32) -> Lidar<'static> {
    Lidar {
        name,
        mount: Pose2D::new(0.0, 0.0, 0.0),
        start_angle,
        fov,
        max_range: 4.0,
    }
}

/// One update of a map with these scans of its lidars.
fn update(map: &mut LocalGridMap<'_, Vec<u8>>, pose: Pose2D, scans: &[&[f32]]) -> LocalUpdate {
    let mut buffers = SensingBuffers::<16, 600, 0>::empty();
    let mut state = buffers.state();
    for (lidar, ranges) in map.config().lidars.iter().zip(scans) {
        lidar.write(&mut state, ranges).unwrap();
    }
    let mut slots = vec![vec![BeamSlot::EMPTY; 200]; map.config().lidars.len()];
    let mut workspaces: Vec<_> = slots
        .iter_mut()
        .map(|s| ScanWorkspace::new_in(s, &mut []))
        .collect();
    map.update(&state, pose, &mut workspaces).unwrap()
}

fn map(lidars: &'static [Lidar<'static>]) -> LocalGridMap<'static, Vec<u8>> {
    LocalGridMap::new_in(vec![0; 60 * 50], config(lidars)).unwrap()
}

fn range() -> impl Strategy<Value = f32> {
    prop_oneof![8 => 1.0f32..4.5, 1 => Just(f32::INFINITY), 1 => Just(f32::NAN)]
}

/// A pose that no window is undecided about: not half a cell from where the centre can lie.
fn decided() -> impl Strategy<Value = Pose2D> {
    let cells = || (-400i32..400, -0.4f32..0.4).prop_map(|(whole, part)| (whole as f32 + part) * RESOLUTION);
    (cells(), cells(), -3.0f32..3.0).prop_map(|(x, y, theta)| Pose2D::new(x, y, theta))
}

proptest! {
    #[test]
    fn a_far_jump_leaves_no_stale_cell(
        ranges in prop::collection::vec(range(), 90),
        along in prop_oneof![60i32..5000, -5000i32..-59],
        across in prop_oneof![-2i32..2, 50i32..5000],
        swap: bool,
    ) {
        static LIDARS: [Lidar; 1] = [lidar("l", -3.0, 6.0)];
        let mut map = map(&LIDARS);
        update(&mut map, Pose2D::default(), &[&ranges]);
        prop_assert!(map.data().iter().any(|cell| *cell != UNKNOWN));
        let (x, y) = if swap { (across, along.abs().max(60)) } else { (along, across) };
        let to = Pose2D::new(x as f32 * RESOLUTION, y as f32 * RESOLUTION, 0.0);
        update(&mut map, to, &[]);
        prop_assert!(map.data().iter().all(|cell| *cell == UNKNOWN));
    }

    #[test]
    fn the_path_to_a_pose_does_not_matter(
        path in prop::collection::vec(decided(), 0..6),
        to in decided(),
        ranges in prop::collection::vec(range(), 90),
    ) {
        static LIDARS: [Lidar; 1] = [lidar("l", -3.0, 6.0)];
        let (mut straight, mut winding) = (map(&LIDARS), map(&LIDARS));
        for pose in path {
            winding.recenter(pose).unwrap();
        }
        update(&mut straight, to, &[&ranges]);
        update(&mut winding, to, &[&ranges]);
        prop_assert_eq!(straight.offset(), winding.offset());
        prop_assert_eq!(straight.data(), winding.data());
    }

    #[test]
    fn two_lidars_at_one_pose_are_one(
        left in prop::collection::vec(range(), 65),
        right in prop::collection::vec(range(), 65),
        pose in decided(),
    ) {
        // One degree-like step for all; 15 beams of the merged scan, between the two, say nothing: a
        // metre away no ray of one lidar comes near a mark of the other.
        const STEP: f32 = 1.0 / 64.0;
        static TWO: [Lidar; 2] = [lidar("right", 0.0, 64.0 * STEP), lidar("left", 80.0 * STEP, 64.0 * STEP)];
        static ONE: [Lidar; 1] = [lidar("both", 0.0, 144.0 * STEP)];
        let merged = [&right[..], &[f32::NAN; 15], &left].concat();
        let (mut two, mut one) = (map(&TWO), map(&ONE));
        let of_two = update(&mut two, pose, &[&right, &left]);
        let of_one = update(&mut one, pose, &[&merged]);
        prop_assert_eq!(two.data(), one.data());
        prop_assert_eq!(of_two.marks, of_one.marks);
        prop_assert_eq!((of_two.lidars, of_one.lidars), (2, 1));
    }
}

#[test]
fn a_later_lidar_clears_the_marks_of_an_earlier_one() {
    static LIDARS: [Lidar; 2] = [lidar("a", 0.0, 0.0), lidar("b", 0.0, 0.0)];
    let mut map = map(&LIDARS);
    update(&mut map, Pose2D::default(), &[&[0.5], &[1.0]]);
    assert_eq!(map.value_at(0.5, 0.0), Some(FREE));
    assert_eq!(map.value_at(1.0, 0.0), Some(OCCUPIED));
    update(&mut map, Pose2D::default(), &[&[1.0], &[0.5]]);
    assert_eq!(map.value_at(0.5, 0.0), Some(OCCUPIED));
    assert_eq!(
        map.value_at(1.0, 0.0),
        Some(OCCUPIED),
        "the second sees no farther"
    );
}

#[test]
fn a_mounted_lidar_sees_from_where_it_sits() {
    let mounted = Lidar {
        mount: Pose2D::new(0.3, 0.0, core::f32::consts::FRAC_PI_2),
        ..lidar("l", 0.0, 0.0)
    };
    let lidars: &'static [_] = vec![mounted].leak();
    let mut map = map(lidars);
    update(
        &mut map,
        Pose2D::new(0.01, 0.01, core::f32::consts::PI),
        &[&[0.52]],
    );
    // The robot looks along -x, the lidar sits 0.3 m ahead and looks to the robot's left: -y.
    assert_eq!(map.value_at(-0.29, 0.01 - 0.52), Some(OCCUPIED));
    assert_eq!(map.value_at(-0.29, -0.3), Some(FREE));
    assert_eq!(map.value_at(0.01, -0.3), Some(UNKNOWN));
}

#[test]
fn a_sensor_outside_marks_but_frees_nothing() {
    let outside = Lidar {
        mount: Pose2D::new(2.0, 0.0, core::f32::consts::PI),
        ..lidar("l", 0.0, 0.0)
    };
    let lidars: &'static [_] = vec![outside].leak();
    let mut map = map(lidars);
    let told = update(&mut map, Pose2D::new(0.01, 0.01, 0.0), &[&[1.52]]);
    assert_eq!((told.marks, told.lidars), (1, 1));
    assert_eq!(map.value_at(0.49, 0.01), Some(OCCUPIED));
    assert_eq!(map.data().iter().filter(|cell| **cell == FREE).count(), 0);
}

#[test]
fn scans_of_no_and_one_range() {
    static LIDARS: [Lidar; 3] = [
        lidar("none", 0.0, 1.0),
        lidar("one", 0.0, 1.0),
        lidar("gone", 0.0, 1.0),
    ];
    let mut map = map(&LIDARS);
    let told = update(&mut map, Pose2D::default(), &[&[], &[1.0]]);
    assert_eq!((told.empty_lidars, told.lidars, told.missing_lidars), (1, 1, 1));
    assert_eq!(
        map.value_at(1.0, 0.0),
        Some(OCCUPIED),
        "one beam points to start_angle"
    );
}
