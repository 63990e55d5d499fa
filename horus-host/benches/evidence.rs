//! Evidence grids: fusion kernels beside a plain loop in f64, and whole ticks of local mapping.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use horus_core::distance::{DistanceBuffers, EnvelopeVertex};
use horus_core::evidence::{
    BeamLimits, BinaryThresholds, EvidenceF32, EvidenceU8, EvidenceU16, Flatscan, FusionOperator, FusionRule,
    Lattice, LocalMapping, LocalMappingConfig, MappingBuffers, MassCell, Masses, SensorConfig, SensorModel,
    SensorScan, class_bytes, fuse,
};
use horus_core::prelude::Pose2D;
use horus_core::storage::bitmap_words;

const CELLS: usize = 128 * 128;

/// States and sensor masses: a third of the pairs in conflict, some vacuous.
fn pairs() -> Vec<(Masses, Masses)> {
    let share = |i: usize, n: usize| (i % n) as f32 / n as f32;
    let pair = |i: usize| {
        let state = Masses::known(0.9 * share(i, 97), 0.9 * share(i, 89) * (1.0 - share(i, 97)));
        let sensor = match i % 7 {
            0 => Masses::known(0.0, 0.0),
            1 | 2 => Masses::known(0.0, 0.7),
            _ => Masses::known(0.4, 0.0),
        };
        (state.expect("masses"), sensor.expect("masses"))
    };
    (0..CELLS).map(pair).collect()
}

/// PCR6 as one would write it.
#[inline(never)]
fn naive_f64(state: &mut [[f64; 3]], sensor: &[[f64; 3]]) {
    let ratio = |n: f64, d: f64| if d == 0.0 { 0.0 } else { n / d };
    for ([f1, o1, u1], [f2, o2, u2]) in state.iter_mut().zip(sensor) {
        let f =
            *f1 * f2 + *f1 * u2 + *u1 * f2 + ratio(*f1 * *f1 * o2, *f1 + o2) + ratio(f2 * f2 * *o1, f2 + *o1);
        let o =
            *o1 * o2 + *o1 * u2 + *u1 * o2 + ratio(*o1 * *o1 * f2, *o1 + f2) + ratio(o2 * o2 * *f1, o2 + *f1);
        (*f1, *o1, *u1) = (f, o, *u1 * u2);
    }
}

fn kernels(c: &mut Criterion) {
    let pairs = pairs();
    let mut group = c.benchmark_group("fuse");
    group.throughput(Throughput::Elements(CELLS as u64));
    let wide = |m: &Masses| [m.free(), m.occupied(), m.uncertain()].map(f64::from);
    let before: Vec<_> = pairs.iter().map(|p| wide(&p.0)).collect();
    let sensor: Vec<_> = pairs.iter().map(|p| wide(&p.1)).collect();
    let mut state = before.clone();
    group.bench_function("pcr6 plain f64", |b| {
        b.iter(|| {
            state.copy_from_slice(&before);
            naive_f64(black_box(&mut state), black_box(&sensor));
        });
    });
    for operator in FusionOperator::ALL {
        kernel::<EvidenceF32>(&mut group, &pairs, operator, "f32");
        kernel::<EvidenceU16>(&mut group, &pairs, operator, "u16");
        kernel::<EvidenceU8>(&mut group, &pairs, operator, "u8");
    }
    group.finish();
}

fn kernel<M: MassCell>(
    group: &mut criterion::BenchmarkGroup<'_, criterion::measurement::WallTime>,
    pairs: &[(Masses, Masses)],
    operator: FusionOperator,
    name: &str,
) {
    let rule = FusionRule::new(operator);
    if M::supports(rule).is_err() {
        return;
    }
    let before: Vec<_> = pairs.iter().map(|p| M::from_masses(p.0)).collect();
    let sensor: Vec<_> = pairs.iter().map(|p| M::from_masses(p.1)).collect();
    let mut state = before.clone();
    group.bench_function(BenchmarkId::new(operator.as_str(), name), |b| {
        b.iter(|| {
            state.copy_from_slice(&before);
            fuse(rule, black_box(&mut state), black_box(&sensor))
        });
    });
}

/// A robot that turns in a square room, seen by 360 beams.
fn ticks(c: &mut Criterion) {
    let mut group = c.benchmark_group("local mapping");
    for side in [128u32, 256] {
        let lattice = |frame| Lattice::new(side, side, 0.05, [-0.5, -0.5], frame).expect("a lattice");
        let cells = (side * side) as usize;
        let mut masses = vec![EvidenceU16::default(); cells];
        let (mut classes, mut limits) = (vec![0; class_bytes(side, side)], vec![BeamLimits::EMPTY; 360]);
        let mut binary = vec![0; bitmap_words(side, side)];
        let (mut squared, mut vertices) = (vec![0u16; cells], vec![EnvelopeVertex::EMPTY; side as usize]);
        let sensors = [SensorConfig {
            lattice: lattice("robot"),
            mount: Pose2D::default(),
            model: SensorModel::default(),
        }];
        let config = LocalMappingConfig {
            lattice: lattice("odom"),
            rule: FusionRule::default(),
            sensors: &sensors,
            inpaint: &[],
            thresholds: BinaryThresholds::default(),
            max_distance: 2.0,
        };
        let buffers = MappingBuffers {
            cells: &mut masses,
            classes: &mut classes,
            limits: &mut limits,
            binary: &mut binary,
            distance: DistanceBuffers {
                cells: &mut squared[..],
                vertices: &mut vertices[..],
            },
        };
        let mut mapping = LocalMapping::new_in(buffers, config).expect("a map");
        let angles: Vec<f32> = (0..360).map(|i| (i as f32 - 180.0) * 0.017_453).collect();
        let mut ranges = vec![0.0f32; 360];
        let mut tick = 0;
        group.bench_function(BenchmarkId::new("tick, 360 beams", side), |b| {
            b.iter(|| {
                tick += 1;
                let t = tick as f32 * 0.05;
                let robot = Pose2D::new(libm::cosf(t), libm::sinf(t), t);
                for (range, angle) in ranges.iter_mut().zip(&angles) {
                    let (s, c) = libm::sincosf(robot.theta + angle);
                    let wall = |at: f32, d: f32| (2.8 * d.signum() - at) / d;
                    *range = wall(robot.x, c).min(wall(robot.y, s));
                }
                let scan = Flatscan {
                    angles: &angles,
                    ranges: &ranges,
                    invalid_range_threshold: 0.05,
                    out_of_range_threshold: 8.0,
                    visibilities: None,
                };
                mapping.tick(&[SensorScan { sensor: 0, scan }], robot)
            });
        });
    }
    group.finish();
}

criterion_group!(benches, kernels, ticks);
criterion_main!(benches);
