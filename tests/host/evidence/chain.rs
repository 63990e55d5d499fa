//! The chain of local mapping in core against the std version.

use horus_core::evidence::{
    EvidenceU16, FusionOperator, LocalMapping, LocalMappingBuffers, MassCell, SensorScan, class_bytes,
};
use horus_core::storage::bitmap_words;
use horus_host::reference::evidence::{LocalMapping as StdMapping, Masses};

use crate::scene::{self, Scene};

type Buffers = LocalMappingBuffers<{ 60 * 56 }, { class_bytes(72, 64) }, { bitmap_words(60, 56) }, 180>;

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

/// Drives for so many ticks and returns the largest difference met; with `synced`, the std version starts each tick
/// from core's state.
fn drive(operator: FusionOperator, ticks: u32, synced: bool) -> f64 {
    let (sensors, inpaint) = (scene::sensors(), scene::inpaint());
    let config = scene::config(operator, &sensors, &inpaint);
    let mut buffers = Box::new(Buffers::empty());
    let mut core = LocalMapping::new_in(buffers.split(), config).unwrap();
    let mut std = StdMapping::new(scene::std_config(&config));
    let mut scene = Scene::new(7);
    let angles = scene::angles();
    let (mut most, mut moved, mut conflicts) = (0.0f64, 0, 0);
    for tick in 0..ticks {
        let robot = scene.robot(tick);
        // The sonars tick at a third of the rate.
        let due = if tick % 3 == 0 { 2 } else { 1 };
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
    assert!(
        moved > ticks / 3 && conflicts > 100 * ticks,
        "{moved} {conflicts}"
    );
    most
}

#[test]
fn one_tick_from_the_same_state() {
    for operator in FusionOperator::ALL {
        let most = drive(operator, 60, true) / STEP;
        println!("{operator}: {most:.2} / 65535");
        let bound = match operator {
            FusionOperator::Pcr6 | FusionOperator::JosangAverage => 2.0,
            FusionOperator::DempsterShafer | FusionOperator::JosangCumulative => 8.0,
        };
        assert!(most <= bound, "{operator}: {most} / 65535");
    }
}

#[test]
fn a_whole_drive_without_resynchronising() {
    for operator in FusionOperator::ALL {
        let most = drive(operator, 300, false);
        println!("{operator}: {most:e}");
        let bound = match operator {
            FusionOperator::Pcr6 | FusionOperator::JosangAverage => 5e-3,
            FusionOperator::DempsterShafer | FusionOperator::JosangCumulative => 5e-2,
        };
        assert!(most <= bound, "{operator}: {most}");
    }
}

#[test]
fn bytes_and_floats_run_the_same_chain() {
    fn run<M: MassCell>() -> Vec<bool> {
        let (sensors, inpaint) = (scene::sensors(), scene::inpaint());
        let config = scene::config(FusionOperator::Pcr6, &sensors, &inpaint);
        let mut buffers = Box::new(LocalMappingBuffers::<
            { 60 * 56 },
            { class_bytes(72, 64) },
            { bitmap_words(60, 56) },
            180,
            M,
        >::empty());
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
