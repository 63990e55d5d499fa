use std::collections::BTreeSet;

use super::{Disc, Drive, Lidar, OrientedBox, Pose, Segment, SimConfig, SimTick, Simulation, World};

fn simulation(seed: u64) -> Simulation {
    Simulation::new(SimConfig {
        seed,
        ..SimConfig::default()
    })
}

/// FNV-1a over every bit of the ticks.
fn digest(ticks: &[SimTick]) -> u64 {
    let words = ticks.iter().flat_map(|tick| {
        let Pose { x, y, theta } = tick.robot;
        let pose = [tick.stamp_ns, x.to_bits(), y.to_bits(), theta.to_bits()];
        let ranges = tick.ranges.iter().map(|range| u64::from(range.to_bits()));
        pose.into_iter().chain(ranges)
    });
    words.fold(0xcbf2_9ce4_8422_2325, |hash, word| {
        (hash ^ word).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

#[test]
fn the_same_seed_gives_the_same_bits_on_every_machine() {
    let ticks: Vec<_> = simulation(1).collect();
    assert_eq!(digest(&ticks), 12_696_151_571_591_242_246);
    assert_ne!(digest(&ticks), digest(&simulation(2).collect::<Vec<_>>()));
}

#[test]
fn ticks_are_numbered_by_time() {
    let config = SimConfig {
        ticks: 3,
        people: 0,
        start_ns: 5,
        tick_ns: 7,
        ..SimConfig::default()
    };
    let simulation = Simulation::new(config);
    assert_eq!(simulation.len(), 3);
    let stamps: Vec<_> = simulation.map(|tick| tick.stamp_ns).collect();
    assert_eq!(stamps, [5, 12, 19]);
}

#[test]
fn extreme_configurations_end() {
    let with = |ticks, tick_ns| {
        Simulation::new(SimConfig {
            ticks,
            tick_ns,
            start_ns: u64::MAX,
            people: 1,
            ..SimConfig::default()
        })
    };
    assert_eq!(with(0, 1).next(), None);
    let last = with(u32::MAX, u64::MAX).nth(1).unwrap();
    assert_eq!((last.stamp_ns, last.ranges.len()), (u64::MAX, 360));
}

#[test]
fn the_robot_keeps_clear_of_everything_and_visits_many_rooms() {
    for seed in 0..40 {
        let simulation = simulation(seed);
        let world = simulation.world();
        let mut rooms = BTreeSet::new();
        for i in 0..1200 {
            let seconds = f64::from(i) * 0.05;
            let Pose { x, y, .. } = simulation.drive().pose_at(seconds);
            let clearance = world.clearance(x, y);
            assert!(clearance >= 0.35, "seed {seed}, {seconds} s: {clearance} m");
            rooms.insert(world.room_at(x, y).unwrap());
            for person in simulation.people() {
                let apart = person.disc_at(seconds).distance((x, y));
                let least = Drive::ROBOT_RADIUS + 0.1;
                assert!(apart >= least, "seed {seed}, {seconds} s: {apart} m");
            }
        }
        assert!(rooms.len() >= 7, "seed {seed}: {rooms:?}");
    }
}

#[test]
fn rooms_change_only_within_doors() {
    for seed in 0..10 {
        let world = World::building(seed);
        let drive = Drive::through(&world);
        let mut passages = 0;
        let mut last = drive.pose_at(0.0);
        for i in 1..=6000 {
            let now = drive.pose_at(f64::from(i) * 0.01);
            if world.room_at(now.x, now.y) != world.room_at(last.x, last.y) {
                passages += 1;
                // A door has a wall on either side, half of its width away.
                let clearance = world.clearance(now.x, now.y);
                assert!((0.45..0.56).contains(&clearance), "seed {seed}: {clearance}");
            }
            last = now;
        }
        assert!(passages >= 6, "seed {seed}: {passages}");
    }
}

#[test]
fn the_drive_is_smooth_and_steady() {
    for seed in 0..20 {
        let drive = Drive::through(&World::building(seed));
        for i in 0..12_000 {
            let seconds = f64::from(i) * 0.01;
            let (a, b) = (drive.pose_at(seconds), drive.pose_at(seconds + 0.01));
            let moved = (b.x - a.x).hypot(b.y - a.y);
            assert!(
                (0.0079..=0.008_000_1).contains(&moved),
                "{seed} {seconds} {moved}"
            );
            let turned = libm::remainder(b.theta - a.theta, std::f64::consts::TAU);
            assert!(turned.abs() < 0.02, "seed {seed}, {seconds} s: {turned} rad");
            let ahead = (b.y - a.y).atan2(b.x - a.x) - a.theta;
            let aside = libm::remainder(ahead, std::f64::consts::TAU);
            assert!(aside.abs() < 0.02, "seed {seed}, {seconds} s: {aside} rad");
        }
    }
}

#[test]
fn people_walk_around_furniture_and_pass_the_robot() {
    for seed in 0..20 {
        let simulation = simulation(seed);
        assert!(simulation.people().len() >= 6, "seed {seed}");
        for person in simulation.people() {
            assert!((0.2..=0.3).contains(&person.radius()));
            let mut nearest = f64::INFINITY;
            let mut travelled = 0.0;
            let mut last = person.disc_at(0.0);
            for i in 0..1200 {
                let seconds = f64::from(i) * 0.05;
                let disc = person.disc_at(seconds);
                let clearance = simulation.world().clearance(disc.x, disc.y);
                assert!(clearance >= disc.radius, "seed {seed}: {clearance}");
                let robot = simulation.drive().pose_at(seconds);
                nearest = disc.distance((robot.x, robot.y)).min(nearest);
                travelled += (disc.x - last.x).hypot(disc.y - last.y);
                last = disc;
            }
            assert!(nearest < 2.0, "seed {seed}: {nearest}");
            assert!(travelled > 30.0, "seed {seed}: {travelled}");
        }
    }
}

#[test]
fn rooms_are_furnished_and_between_4_and_6_m() {
    for seed in 0..20 {
        let world = World::building(seed);
        let walls = world.plan().walls.iter().map(|wall| wall.boxes().len()).sum();
        let furniture = world.boxes()[walls..].len() + world.discs().len();
        assert!(furniture >= 16, "seed {seed}: {furniture}");
        for wall in &world.plan().walls {
            let length = wall.span.1 - wall.span.0;
            assert!((4.0..=6.0).contains(&length));
        }
    }
}

#[test]
fn exact_distances_end_on_surfaces_and_cross_none() {
    let simulation = simulation(3);
    let lidar = Lidar::default();
    for i in 0..60 {
        let robot = simulation.drive().pose_at(f64::from(i));
        let sensor = robot.mounted(&lidar.mount);
        let distances = lidar.distances(simulation.world(), &[], &robot);
        for (beam, &distance) in distances.iter().enumerate() {
            let bearing = sensor.theta - std::f64::consts::PI + (beam as f64).to_radians();
            let point = |s: f64| (sensor.x + s * bearing.cos(), sensor.y + s * bearing.sin());
            let clearance = |s: f64| {
                let (x, y) = point(s);
                simulation.world().clearance(x, y)
            };
            if distance.is_finite() {
                assert!(clearance(distance) < 1e-5);
            }
            // March along the beam: no step may enter an obstacle before the end.
            let mut s = 0.0;
            while s < distance.min(8.0) - 0.01 {
                let free = clearance(s);
                assert!(
                    free > 0.0,
                    "beam {beam} enters an obstacle at {s} of {distance} m"
                );
                s += free.max(0.002);
            }
        }
    }
}

#[test]
fn scans_hold_noise_and_all_special_values() {
    let simulation = simulation(1);
    let (drive, people) = (simulation.drive().clone(), simulation.people().to_vec());
    let (world, lidar) = (simulation.world().clone(), Lidar::default());
    let (mut nan, mut too_close, mut none, mut hits) = (0, 0, 0, 0);
    let (mut squares, mut of_people) = (0.0, 0);
    for tick in simulation {
        let seconds = (tick.stamp_ns - 1_000_000_000) as f64 * 1e-9;
        assert_eq!(tick.robot, drive.pose_at(seconds));
        assert_eq!(tick.ranges.len(), 360);
        let people: Vec<Disc> = people.iter().map(|p| p.disc_at(seconds)).collect();
        let truth = lidar.distances(&world, &people, &tick.robot);
        let empty = lidar.distances(&world, &[], &tick.robot);
        of_people += truth.iter().zip(&empty).filter(|(a, b)| a != b).count();
        for (&range, &truth) in tick.ranges.iter().zip(&truth) {
            if range.is_nan() {
                nan += 1;
            } else if range == f32::NEG_INFINITY {
                too_close += 1;
            } else if range == f32::INFINITY {
                none += 1;
                assert!(truth > 7.9);
            } else {
                hits += 1;
                assert!((0.12..8.0).contains(&range));
                squares += (f64::from(range) - truth).powi(2);
            }
        }
    }
    let beams = 600 * 360;
    assert_eq!(nan + too_close + none + hits, beams);
    assert!((250..400).contains(&nan), "{nan}");
    assert!((250..400).contains(&too_close), "{too_close}");
    assert!((200..beams / 4).contains(&none), "{none}");
    assert!(of_people > beams / 100, "{of_people}");
    let sigma = (squares / hits as f64).sqrt();
    assert!((0.0098..0.0102).contains(&sigma), "{sigma}");
}

#[test]
fn rays_meet_segments() {
    let edge = Segment {
        a: (2.0, -1.0),
        b: (2.0, 1.0),
    };
    assert_eq!(edge.ray((0.0, 0.0), (1.0, 0.0)), Some(2.0));
    assert_eq!(edge.ray((0.0, 1.0), (1.0, 0.0)), Some(2.0));
    assert_eq!(edge.ray((0.0, 1.1), (1.0, 0.0)), None);
    assert_eq!(edge.ray((3.0, 0.0), (1.0, 0.0)), None);
    assert_eq!(edge.ray((2.0, -2.0), (0.0, 1.0)), None);
    assert_eq!(edge.ray((1.0, 0.0), (0.0, 1.0)), None);
    assert_eq!(edge.distance((5.0, 5.0)), 5.0);
    assert_eq!(edge.distance((0.0, 0.5)), 2.0);
}

#[test]
fn rays_meet_discs() {
    let disc = Disc {
        x: 3.0,
        y: 0.0,
        radius: 1.0,
    };
    assert_eq!(disc.ray((0.0, 0.0), (1.0, 0.0)), Some(2.0));
    assert_eq!(disc.ray((0.0, 1.0), (1.0, 0.0)), Some(3.0));
    assert_eq!(disc.ray((0.0, 1.1), (1.0, 0.0)), None);
    assert_eq!(disc.ray((6.0, 0.0), (1.0, 0.0)), None);
    assert_eq!(disc.ray((3.0, 0.0), (1.0, 0.0)), None);
    assert_eq!(disc.distance((3.0, 0.5)), 0.0);
    assert_eq!(disc.distance((3.0, 3.0)), 2.0);
}

#[test]
fn boxes_know_their_distance() {
    let turned = OrientedBox {
        x: 1.0,
        y: 1.0,
        axis: (0.6, 0.8),
        half_length: 2.0,
        half_width: 1.0,
    };
    for (u, v, distance) in [
        (0.0, 0.0, 0.0),
        (5.0, 0.5, 3.0),
        (0.0, -3.0, 2.0),
        (5.0, 5.0, 5.0),
    ] {
        let found = turned.distance(turned.point(u, v));
        assert!((found - distance).abs() < 1e-12, "({u}, {v}): {found}");
    }
    let inside = turned.edges().map(|edge| edge.distance((1.0, 1.0)));
    assert!(
        inside
            .iter()
            .zip([1.0, 2.0, 1.0, 2.0])
            .all(|(a, b)| (a - b).abs() < 1e-12)
    );
}

#[test]
fn a_mounted_sensor_turns_with_the_robot() {
    let robot = Pose {
        x: 1.0,
        y: 2.0,
        theta: std::f64::consts::FRAC_PI_2,
    };
    let mount = Pose {
        x: 0.5,
        y: 0.0,
        theta: 0.25,
    };
    let sensor = robot.mounted(&mount);
    assert!((sensor.x - 1.0).abs() < 1e-12 && (sensor.y - 2.5).abs() < 1e-12);
    assert_eq!(sensor.theta, robot.theta + 0.25);
}
