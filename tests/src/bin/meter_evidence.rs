//! The meter's rows of evidence grids, which need the RAM of the target for themselves.
#![cfg_attr(target_os = "none", no_std, no_main)]

use horus_core::Error;
use horus_core::distance::DistanceMap;
use horus_core::evidence::{
    BinaryMap, BinaryThresholds, EvidenceF32, EvidenceFusion, EvidenceU8, EvidenceU16, Flatscan,
    FusionOperator, FusionRule, Lattice, LocalMapping, LocalMappingBuffers, LocalMappingConfig, MassCell,
    Masses, SensorConfig, SensorGrid, SensorModel, SensorScan, binary_to_distance, class_bytes, fuse,
};
use horus_core::prelude::{LaserScan, Pose2D};
use horus_core::storage::bitmap_words;
use horus_tests::meter::{Meter, Stat, Table, Target};
use horus_tests::rt::hprintln;
use horus_tests::workload::{BEAMS, Lidar, Office, RESOLUTION, robot};
use horus_tests::{Arena, Once};

#[cfg(target_os = "none")]
horus_tests::start!(run);

#[cfg(not(target_os = "none"))]
fn main() {
    let counted = run();
    std::process::exit(if counted { 0 } else { 2 });
}

const SIDE: u32 = 128;
const CELLS: usize = (SIDE * SIDE) as usize;
const SETTING: &str = "128x128 u16";
const KERNEL: &str = "1000 cells";
const TICKS: u32 = 20;

type Buffers = LocalMappingBuffers<
    CELLS,
    { class_bytes(SIDE, SIDE) },
    { bitmap_words(SIDE, SIDE) },
    BEAMS,
    { SIDE as usize },
>;

/// 109 188 bytes; the kernels' cells lie in it before.
type Memory = Arena<{ size_of::<Buffers>() }>;
const _: () = assert!(size_of::<Buffers>() <= 120 * 1024);

static TARGETS: [Target; 2] = [
    Target {
        setting: KERNEL,
        operation: "fuse, pcr6 on u16",
        limit: 110_000,
    },
    Target {
        setting: SETTING,
        operation: "LocalMapping::tick, 360 beams",
        limit: 6_000_000,
    },
];

fn run() -> bool {
    let Some(meter) = Meter::start() else {
        hprintln!("meter: nothing can be counted here: run it on the target, with tests/meter");
        return false;
    };
    let mut table = Table::new(&TARGETS);
    static MEMORY: Once<Memory> = Once::new(Arena::new());
    // SAFETY: this function runs once.
    let memory = unsafe { MEMORY.take() };
    let done = kernels(&meter, &mut table, memory).and_then(|()| chain(&meter, &mut table, memory));
    if let Err(error) = done {
        hprintln!("meter: {}", error);
        return false;
    }
    table.finish()
}

/// Pairs of masses of which none is vacuous, half of them in conflict.
fn pair(i: usize) -> Result<(Masses, Masses), Error> {
    let share = |i: usize, n: usize| (i % n) as f32 / n as f32;
    let state = Masses::known(0.05 + 0.4 * share(i, 13), 0.05 + 0.45 * share(i, 29))?;
    let sensor = if i.is_multiple_of(2) {
        Masses::known(0.4, 0.0)
    } else {
        Masses::known(0.0, 0.7)
    };
    Ok((state, sensor?))
}

/// The yardstick: PCR6 in f64, as one would write it.
#[inline(never)]
fn pcr6_f64(state: &mut [[f64; 3]], sensor: &[[f64; 3]]) {
    let ratio = |n: f64, d: f64| if d == 0.0 { 0.0 } else { n / d };
    for ([f1, o1, u1], [f2, o2, u2]) in state.iter_mut().zip(sensor) {
        let f =
            *f1 * f2 + *f1 * u2 + *u1 * f2 + ratio(*f1 * *f1 * o2, *f1 + o2) + ratio(f2 * f2 * *o1, f2 + *o1);
        let o =
            *o1 * o2 + *o1 * u2 + *u1 * o2 + ratio(*o1 * *o1 * f2, *o1 + f2) + ratio(o2 * o2 * *f1, o2 + *f1);
        (*f1, *o1, *u1) = (f, o, *u1 * u2);
    }
}

const KERNEL_CELLS: usize = 1000;

fn kernels(meter: &Meter, table: &mut Table, memory: &mut Memory) -> Result<(), Error> {
    fn one<M: MassCell>(
        meter: &Meter,
        table: &mut Table,
        (state, sensor): &mut ([M; KERNEL_CELLS], [M; KERNEL_CELLS]),
        operator: FusionOperator,
        name: &str,
    ) -> Result<(), Error> {
        for (i, (state, sensor)) in state.iter_mut().zip(sensor.iter_mut()).enumerate() {
            let (one, two) = pair(i)?;
            (*state, *sensor) = (M::from_masses(one), M::from_masses(two));
        }
        let (done, cost) = meter.measure(|| fuse(FusionRule::new(operator), state, sensor));
        table.row(KERNEL, name, cost);
        done.map(|_| ())
    }
    for (operator, name) in [
        (FusionOperator::Pcr6, "fuse, pcr6 on u16"),
        (FusionOperator::DempsterShafer, "fuse, dempster_shafer on u16"),
        (FusionOperator::JosangAverage, "fuse, josang_average on u16"),
        (FusionOperator::JosangCumulative, "fuse, josang_cumulative on u16"),
    ] {
        let cells = memory.zeroed::<([EvidenceU16; KERNEL_CELLS], [EvidenceU16; KERNEL_CELLS])>();
        one(meter, table, cells, operator, name)?;
    }
    let bytes = memory.zeroed::<([EvidenceU8; KERNEL_CELLS], [EvidenceU8; KERNEL_CELLS])>();
    one(meter, table, bytes, FusionOperator::Pcr6, "fuse, pcr6 on u8")?;
    let floats = memory.zeroed::<([EvidenceF32; KERNEL_CELLS], [EvidenceF32; KERNEL_CELLS])>();
    one(meter, table, floats, FusionOperator::Pcr6, "fuse, pcr6 on f32")?;

    let (state, sensor) = memory.zeroed::<([[f64; 3]; KERNEL_CELLS], [[f64; 3]; KERNEL_CELLS])>();
    let wide = |m: Masses| [m.free(), m.occupied(), m.uncertain()].map(f64::from);
    for (i, (state, sensor)) in state.iter_mut().zip(sensor.iter_mut()).enumerate() {
        let (one, two) = pair(i)?;
        (*state, *sensor) = (wide(one), wide(two));
    }
    let ((), cost) = meter.measure(|| pcr6_f64(state, sensor));
    table.row(KERNEL, "the same by a plain loop in f64", cost);
    Ok(())
}

fn chain(meter: &Meter, table: &mut Table, memory: &mut Memory) -> Result<(), Error> {
    static OFFICE: Once<Office> = Once::new(Office::empty());
    static LIDAR: Once<Lidar> = Once::new(Lidar::new());
    static ANGLES: Once<[f32; BEAMS]> = Once::new([0.0; BEAMS]);
    // SAFETY: this function runs once.
    let (office, lidar, angles) = unsafe { (OFFICE.take(), LIDAR.take(), ANGLES.take()) };
    let buffers = memory.zeroed::<Buffers>();
    office.build();
    let scan = lidar.measure(office, 0);
    for (i, angle) in angles.iter_mut().enumerate() {
        *angle = scan.angle_min + i as f32 * scan.angle_increment;
    }
    let start = robot(0);
    let sensor = SensorConfig {
        lattice: Lattice::new(SIDE, SIDE, RESOLUTION, [-0.5, -0.5], "robot")?,
        mount: Pose2D::default(),
        model: SensorModel::default(),
    };
    let mut lattice = Lattice::new(SIDE, SIDE, RESOLUTION, [-0.5, -0.5], "odom")?;
    (lattice.pose.x, lattice.pose.y) = (lattice.pose.x + start.x, lattice.pose.y + start.y);
    let sensors = [sensor];
    let config = LocalMappingConfig {
        lattice,
        rule: FusionRule::default(),
        sensors: &sensors,
        inpaint: &[],
        thresholds: BinaryThresholds::default(),
        max_distance: 2.0,
    };
    stages(meter, table, (office, lidar, angles), buffers, &config)?;
    let mut mapping = LocalMapping::new_in(buffers.split(), config)?;
    let mut stat = Stat::default();
    for tick in 0..TICKS {
        let (scan, pose) = (flatscan(lidar.measure(office, tick), angles), robot(tick));
        let scans = [SensorScan { sensor: 0, scan }];
        let (done, cost) = meter.measure(|| mapping.tick(&scans, pose));
        done?;
        if tick > 0 {
            stat.add(cost);
        }
    }
    table.row(SETTING, "LocalMapping::tick, 360 beams", stat);
    Ok(())
}

fn flatscan<'s>(scan: LaserScan<'s>, angles: &'s [f32]) -> Flatscan<'s> {
    Flatscan {
        angles,
        ranges: scan.ranges,
        invalid_range_threshold: scan.range_min,
        out_of_range_threshold: scan.range_max,
        visibilities: None,
    }
}

/// The stages of a tick one by one.
fn stages(
    meter: &Meter,
    table: &mut Table,
    (office, lidar, angles): (&Office, &mut Lidar, &[f32]),
    buffers: &mut Buffers,
    config: &LocalMappingConfig<'_>,
) -> Result<(), Error> {
    let buffers = buffers.split();
    let [sensor] = config.sensors else { return Ok(()) };
    let mut map = EvidenceFusion::new_in(buffers.cells, config.lattice, config.rule)?;
    let mut grid = SensorGrid::new_in(buffers.classes, sensor.lattice, sensor.model)?;
    let mut binary = BinaryMap::new_in(buffers.binary, SIDE, SIDE)?;
    let mut distance = DistanceMap::new_in(buffers.distance);
    let mut stats = [Stat::default(); 5];
    for tick in 0..TICKS {
        let (scan, pose) = (flatscan(lidar.measure(office, tick), angles), robot(tick));
        let (shift, moving) = meter.measure(|| map.recenter(pose));
        let (projected, projecting) = meter.measure(|| grid.project(&scan, sensor.mount, buffers.limits));
        let (fused, fusing) = meter.measure(|| map.fuse(&grid, pose));
        let (cut, cutting) = meter.measure(|| binary.take(map.cells(), config.thresholds));
        let (measured, measuring) = meter.measure(|| {
            binary_to_distance(&binary, RESOLUTION, config.max_distance, &mut distance)?;
            Ok(distance.advance(u32::MAX))
        });
        shift
            .and(projected)
            .and(fused.map(|_| ()))
            .and(cut)
            .and(measured)?;
        let costs = [moving, projecting, fusing, cutting, measuring];
        stats
            .iter_mut()
            .zip(costs)
            .filter(|_| tick > 0)
            .for_each(|(stat, cost)| stat.add(cost));
    }
    let names = [
        "EvidenceFusion::recenter, by a cell",
        "SensorGrid::project, 360 beams",
        "EvidenceFusion::fuse",
        "BinaryMap::take",
        "binary_to_distance, u16",
    ];
    names
        .into_iter()
        .zip(stats)
        .for_each(|(name, stat)| table.row(SETTING, name, stat));
    Ok(())
}
