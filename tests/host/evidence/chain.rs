//! The chain of local mapping in core against the std version.

use horus_core::error::{Buffer, Parameter};
use horus_core::evidence::{
    EvidenceU16, FusionOperator, LocalMapping, LocalMappingBuffers, LocalMappingConfig, MassCell, SensorScan,
    class_bytes,
};
use horus_core::prelude::{Error, Pose2D};
use horus_core::storage::bitmap_words;
use horus_host::reference::evidence::{LocalMapping as StdMapping, Masses};
use horus_host::reference::signed_squared_distances;

use crate::scene::{self, Scene};

type Buffers<M = EvidenceU16> =
    LocalMappingBuffers<{ 60 * 56 }, { class_bytes(72, 64) }, { bitmap_words(60, 56) }, 180, 120, M, i16>;

/// One step of a 16-bit mass.
const STEP: f64 = 1.0 / 65_535.0;

fn as_masses(cells: &[EvidenceU16]) -> Vec<Masses> {
    let exact = |v: u16| f64::from(v) / 65_535.0;
    cells
        .iter()
        .map(|c| Masses::known(exact(c.free_steps()), exact(c.occupied_steps())))
        .collect()
}

/// The largest difference of free or occupied over all cells.
fn distance(core: &[EvidenceU16], std: &[Masses]) -> f64 {
    let pairs = as_masses(core).into_iter().zip(std);
    pairs.fold(0.0, |most, (a, b)| {
        most.max((a.free - b.free).abs())
            .max((a.occupied - b.occupied).abs())
    })
}

/// Drives for so many ticks with one sensor or both, and returns the largest difference met; with `synced`, the std
/// version starts each tick from core's state.
fn drive(operator: FusionOperator, ticks: u32, synced: bool, used: usize) -> f64 {
    let (sensors, inpaint) = (scene::sensors(), scene::inpaint());
    let config = scene::config(operator, &sensors, &inpaint);
    let mut buffers = Box::new(Buffers::<EvidenceU16>::empty());
    let mut core = LocalMapping::new_in(buffers.split(), config).unwrap();
    let mut std = StdMapping::new(scene::std_config(&config));
    let mut scene = Scene::new(7);
    let angles = scene::angles();
    let (mut most, mut moved, mut conflicts) = (0.0f64, 0, 0);
    for tick in 0..ticks {
        let robot = scene.robot(tick);
        // The sonars tick at a third of the rate.
        let due = if tick % 3 == 0 { used } else { 1 };
        let scans: Vec<_> = (0..due)
            .map(|i| {
                let mount = sensors[i].mount;
                let (s, c) = libm::sincosf(robot.theta);
                let at = [
                    robot.x + c * mount.x - s * mount.y,
                    robot.y + s * mount.x + c * mount.y,
                    robot.theta + mount.theta,
                ];
                scene.scan(&angles[i], at)
            })
            .collect();
        let given: Vec<_> = scans
            .iter()
            .enumerate()
            .map(|(sensor, scan)| SensorScan {
                sensor,
                scan: scan.borrowed(),
            })
            .collect();
        if synced {
            std.cells = as_masses(core.evidence().cells());
        }
        let report = core.tick(&given, robot).unwrap();
        let scans: Vec<_> = scans
            .iter()
            .enumerate()
            .map(|(i, scan)| (i, scan.std()))
            .collect();
        let shift = std.tick(&scans, [robot.x, robot.y, robot.theta]).unwrap();
        assert_eq!(report.shift, shift, "tick {tick}");
        assert_eq!(core.info().offset(), std.offset);
        moved += u32::from(shift != [0, 0]);
        conflicts += report.fusion.conflicts;
        let difference = distance(core.evidence().cells(), &std.cells);
        most = most.max(difference);

        // Painting and thresholds: equal but for cells within the difference of a threshold.
        let (painted, binary) = (std.inpainted(), std.binary());
        let thresholds = &std.config.thresholds;
        for (i, (masses, occupied)) in painted.iter().zip(&binary).enumerate() {
            let (gx, gy) = (i as u32 % 60, i as u32 / 60);
            let near = (masses.free - thresholds.free_threshold).abs() <= difference + STEP
                || (masses.occupied - thresholds.occupied_threshold).abs() <= difference + STEP;
            let got = core.binary().is_occupied(gx, gy);
            assert!(
                near || got == Some(*occupied),
                "tick {tick}: ({gx}, {gy}) {masses:?}"
            );
            let got = core.inpainted_at(gx, gy).unwrap();
            let off = (f64::from(got.free()) - masses.free).abs();
            assert!(
                off <= difference + STEP,
                "tick {tick}: ({gx}, {gy}) {got:?} {masses:?}"
            );
        }
    }
    // Distances: exact, given core's binary map; by the brute force of the std version, so for the last tick only.
    let occupied: Vec<bool> = (0..56).flat_map(|gy| core.binary().row(gy)).collect();
    let expected = signed_squared_distances(&occupied, 60, 400);
    let squared = core.distance().squared().iter().map(|d| i64::from(*d));
    assert!(squared.eq(expected));

    assert!(
        moved > ticks / 3 && conflicts > 100 * ticks,
        "{moved} {conflicts}"
    );
    most
}

#[test]
fn one_tick_from_the_same_state() {
    for operator in FusionOperator::ALL {
        for used in [1, 2] {
            let most = drive(operator, 40, true, used) / STEP;
            println!("{operator}, {used} sensors: {most:.2} / 65535");
            // Dempster's rule divides by what is not in conflict: a second scan in the same tick enlarges what
            // the first was rounded by.
            let enlarges = operator == FusionOperator::DempsterShafer && used == 2;
            let bound = if enlarges { 4.0 } else { 2.0 };
            assert!(most <= bound, "{operator}, {used} sensors: {most} / 65535");
        }
    }
}

#[test]
fn a_whole_drive_without_resynchronising() {
    for operator in FusionOperator::ALL {
        let most = drive(operator, 200, false, 2);
        println!("{operator}: {most:e}");
        let bound = match operator {
            FusionOperator::Pcr6 | FusionOperator::JosangAverage => 5e-3,
            FusionOperator::DempsterShafer | FusionOperator::JosangCumulative => 1e-3,
        };
        assert!(most <= bound, "{operator}: {most}");
    }
}

#[test]
fn bytes_and_floats_run_the_same_chain() {
    fn run<M: MassCell>() -> Vec<bool> {
        let (sensors, inpaint) = (scene::sensors(), scene::inpaint());
        let config = scene::config(FusionOperator::Pcr6, &sensors, &inpaint);
        let mut buffers = Box::new(Buffers::<M>::empty());
        let mut core = LocalMapping::new_in(buffers.split(), config).unwrap();
        let mut scene = Scene::new(3);
        for tick in 0..10 {
            let robot = scene.robot(tick);
            let scan = scene.scan(&scene::angles()[0], [robot.x, robot.y, robot.theta]);
            let scan = SensorScan {
                sensor: 0,
                scan: scan.borrowed(),
            };
            core.tick(&[scan], robot).unwrap();
        }
        let cells = (0..56).flat_map(|gy| (0..60).map(move |gx| (gx, gy)));
        cells
            .map(|(gx, gy)| core.binary().is_occupied(gx, gy).unwrap())
            .collect()
    }
    let (words, bytes, floats) = (
        run::<EvidenceU16>(),
        run::<horus_core::evidence::EvidenceU8>(),
        run::<horus_core::evidence::EvidenceF32>(),
    );
    let differing = |other: &[bool]| words.iter().zip(other).filter(|(a, b)| a != b).count();
    assert!(differing(&floats) <= 2, "{}", differing(&floats));
    assert!(differing(&bytes) <= 60 * 56 / 50, "{}", differing(&bytes));
}

#[test]
fn the_distance_stage_can_be_split() {
    let (sensors, inpaint) = (scene::sensors(), scene::inpaint());
    let config = scene::config(FusionOperator::Pcr6, &sensors, &inpaint);
    let mut whole = Box::new(Buffers::<EvidenceU16>::empty());
    let mut split = Box::new(Buffers::<EvidenceU16>::empty());
    let mut whole = LocalMapping::new_in(whole.split(), config).unwrap();
    let mut split = LocalMapping::new_in(split.split(), config).unwrap();
    let mut scene = Scene::new(5);
    let (mut begun, mut ended) = (None, 0);
    for tick in 0..20 {
        let robot = scene.robot(tick);
        let scan = scene.scan(&scene::angles()[0], [robot.x, robot.y, robot.theta]);
        let scans = [SensorScan {
            sensor: 0,
            scan: scan.borrowed(),
        }];
        whole.tick(&scans, robot).unwrap();
        let report = split.tick_within(&scans, robot, 40).unwrap();
        assert_eq!(whole.evidence().cells(), split.evidence().cells());
        assert_eq!(whole.binary().words(), split.binary().words());
        let now = || (*whole.info(), whole.distance().squared().to_vec());
        let (info, squared) = begun.get_or_insert_with(now);
        assert_eq!(split.distance_info(), info);
        if report.distance_rows_left == 0 {
            assert_eq!(split.distance().squared(), squared);
            begun = None;
            ended += 1;
        } else {
            assert!(split.distance().squared().is_empty());
        }
    }
    // 111 rows, 40 a tick
    assert_eq!(ended, 20 / 3);
}

#[test]
fn bad_input_changes_nothing() {
    let (sensors, inpaint) = (scene::sensors(), scene::inpaint());
    let config = scene::config(FusionOperator::Pcr6, &sensors, &inpaint);
    let mut buffers = Box::new(Buffers::<EvidenceU16>::empty());
    let mut core = LocalMapping::new_in(buffers.split(), config).unwrap();
    let mut scene = Scene::new(5);
    let [angles, _] = scene::angles();
    let seen = scene.scan(&angles, [0.0; 3]);
    let good = SensorScan {
        sensor: 0,
        scan: seen.borrowed(),
    };
    core.tick(&[good], Pose2D::default()).unwrap();
    let before = (core.evidence().cells().to_vec(), *core.info());

    let unsorted = vec![0.1; 180];
    let mut not_a_number = angles.clone();
    not_a_number[3] = f32::NAN;
    let unseen = vec![f32::NAN; 180];
    let far = Pose2D::new(3.0, 0.0, 0.0);
    let short = Error::LengthMismatch {
        needed: 180,
        given: 0,
    };
    type Change<'s> = (&'s dyn Fn(&mut SensorScan<'s>), Error);
    let cases: [Change<'_>; 11] = [
        (&|s| s.sensor = 2, Error::UnknownSensor(2)),
        (&|s| s.scan.angles = &[], Error::EmptyScan),
        (&|s| s.scan.angles = &unsorted, Error::InvalidScan),
        (&|s| s.scan.angles = &not_a_number, Error::InvalidScan),
        (&|s| s.scan.ranges = &[], short),
        (&|s| s.scan.visibilities = Some(&[]), short),
        (&|s| s.scan.visibilities = Some(&unseen), Error::InvalidScan),
        (&|s| s.scan.invalid_range_threshold = f32::NAN, Error::InvalidScan),
        (&|s| s.scan.invalid_range_threshold = 5.0, Error::InvalidScan),
        (&|s| s.scan.out_of_range_threshold = f32::NAN, Error::InvalidScan),
        (
            &|s| (s.scan.angles, s.scan.ranges) = (&[0.0], &[1.0]), // one beam has no width
            Error::InvalidScan,
        ),
    ];
    for (i, (change, expected)) in cases.iter().enumerate() {
        let mut bad = good;
        change(&mut bad);
        // A good scan in front of it is not fused, and the window does not move.
        assert_eq!(core.tick(&[good, bad], far), Err(*expected), "case {i}");
        assert_eq!(
            (core.evidence().cells().to_vec(), *core.info()),
            before,
            "case {i}"
        );
    }
    for robot in [
        Pose2D::new(f32::NAN, 0.0, 0.0),
        Pose2D::new(0.0, 0.0, f32::INFINITY),
    ] {
        assert_eq!(core.tick(&[good], robot), Err(Error::NonFinitePose));
    }
    let lost = Pose2D::new(1e30, 0.0, 0.0);
    assert_eq!(core.tick(&[good], lost), Err(Error::OffsetOutOfRange));
    assert_eq!((core.evidence().cells().to_vec(), *core.info()), before);
}

#[test]
fn configurations_are_checked() {
    let (sensors, inpaint) = (scene::sensors(), scene::inpaint());
    let good = scene::config(FusionOperator::Pcr6, &sensors, &inpaint);
    let refused = |config: LocalMappingConfig<'_>| {
        let mut buffers = Box::new(Buffers::<EvidenceU16>::empty());
        LocalMapping::new_in(buffers.split(), config)
            .map(|_| ())
            .unwrap_err()
    };
    let parameter = Error::InvalidParameter;
    let mut config = good;
    config.thresholds.free_threshold = 1.1;
    assert_eq!(refused(config), parameter(Parameter::FreeThreshold));
    config = good;
    config.thresholds.occupied_threshold = f32::NAN;
    assert_eq!(refused(config), parameter(Parameter::OccupiedThreshold));
    for max_distance in [0.0, -1.0, f32::NAN] {
        config = good;
        config.max_distance = max_distance;
        assert_eq!(refused(config), parameter(Parameter::MaxDistance));
    }
    config = good;
    config.lattice.cell_size = 0.0;
    assert_eq!(refused(config), Error::InvalidResolution(0.0));
    config = good;
    config.rule.ignorance_floor = 1.0;
    assert_eq!(refused(config), parameter(Parameter::IgnoranceFloor));

    let mut bad = sensors;
    bad[1].model.wall_thickness = f32::INFINITY;
    let config = LocalMappingConfig {
        sensors: &bad,
        ..good
    };
    assert_eq!(refused(config), parameter(Parameter::WallThickness));
    let mut bad = sensors;
    bad[1].lattice.rows = 10_000;
    let config = LocalMappingConfig {
        sensors: &bad,
        ..good
    };
    let buffer = Buffer::Classes;
    assert!(matches!(refused(config), Error::BufferTooSmall { buffer: b, .. } if b == buffer));
    let mut bad = inpaint;
    bad[0].x = [0.3, -0.3];
    let config = LocalMappingConfig {
        inpaint: &bad,
        ..good
    };
    assert_eq!(refused(config), parameter(Parameter::InpaintRectangle));

    // A sensor that stands outside the map is told when its scan comes.
    let mut far = sensors;
    far[0].mount.x = 9.0;
    let config = LocalMappingConfig {
        sensors: &far,
        ..good
    };
    let mut buffers = Box::new(Buffers::<EvidenceU16>::empty());
    let mut core = LocalMapping::new_in(buffers.split(), config).unwrap();
    let seen = Scene::new(1).scan(&scene::angles()[0], [0.0; 3]);
    let scan = SensorScan {
        sensor: 0,
        scan: seen.borrowed(),
    };
    let refused = core.tick(&[scan], Pose2D::default());
    assert_eq!(refused, Err(Error::SensorOutsideMap(0)));
}
