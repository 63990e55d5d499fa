//! The same drive in core and std version.

use horus_core::local::{BufferSlot, GridMapView};
use horus_core::prelude::*;
use horus_host::reference;
use proptest::prelude::*;

/// Most beams of a scan.
pub const BEAMS: usize = 40;

/// A map and its sensors.
#[derive(Clone, Debug)]
pub struct Setup {
    pub width: u32,
    pub height: u32,
    pub resolution: f32,
    pub footprint: Footprint,
    /// Radius of the footprint in cells.
    pub radius_cells: f32,
    /// Lidars that others own, and that the map does.
    pub lidars: (usize, usize),
    pub has_odometry: bool,
}

pub fn setup() -> impl Strategy<Value = Setup> {
    let footprint = prop_oneof![
        Just(Footprint::Rectangular),
        Just(Footprint::Circular),
        Just(Footprint::None)
    ];
    let resolution = prop_oneof![Just(0.05f32), Just(0.1), Just(0.25), 0.01f32..0.5];
    let radius = prop_oneof![4 => 0.0f32..12.0, 1 => Just(1e30)];
    let lidars = (0usize..3, 0usize..2);
    let size = (0u32..40, 0u32..40);
    (size, resolution, footprint, radius, lidars, any::<bool>()).prop_map(
        |((width, height), resolution, footprint, radius_cells, lidars, has_odometry)| Setup {
            width,
            height,
            resolution,
            footprint,
            radius_cells,
            lidars,
            has_odometry,
        },
    )
}

/// A lidar's scan; lengths in cells.
#[derive(Clone, Debug)]
pub struct Scan {
    pub mount: (f32, f32, f32),
    pub start_angle: f32,
    pub fov: f32,
    pub max_range: f32,
    pub ranges: Vec<f32>,
}

fn range() -> impl Strategy<Value = f32> {
    prop_oneof![
        12 => 0.0f32..40.0,
        2 => -5.0f32..5.0,
        1 => Just(f32::INFINITY),
        1 => Just(f32::NEG_INFINITY),
        1 => Just(f32::NAN),
        1 => Just(0.0),
        1 => any::<f32>(),
        1 => 1e5f32..1e9,
    ]
}

pub fn scan() -> impl Strategy<Value = Scan> {
    let mount = prop_oneof![
        3 => Just((0.0f32, 0.0f32, 0.0f32)),
        2 => (-5.0f32..5.0, -5.0f32..5.0, -4.0f32..4.0),
        1 => (-60.0f32..60.0, -60.0f32..60.0, -4.0f32..4.0),
        1 => Just((f32::NAN, 0.0, 0.0)),
    ];
    let max_range = prop_oneof![8 => 0.0f32..60.0, 1 => Just(f32::INFINITY), 1 => Just(-1.0)];
    let angle = prop_oneof![8 => -4.0f32..4.0, 1 => Just(0.0), 1 => any::<f32>()];
    let ranges = prop::collection::vec(range(), 0..BEAMS);
    (mount, angle, -7.0f32..7.0, max_range, ranges).prop_map(
        |(mount, start_angle, fov, max_range, ranges)| Scan {
            mount,
            start_angle,
            fov,
            max_range,
            ranges,
        },
    )
}

/// A robot's pose; lengths in cells.
pub fn pose() -> impl Strategy<Value = (f32, f32, f32)> {
    let near = || prop_oneof![4 => -8.0f32..8.0, 1 => (-16i8..16).prop_map(|half| f32::from(half) * 0.5)];
    prop_oneof![
        6 => (near(), near(), -4.0f32..4.0),
        2 => (-200.0f32..200.0, -200.0f32..200.0, -4.0f32..4.0),
        1 => (any::<f32>(), any::<f32>(), any::<f32>()),
    ]
}

/// What happens in one update.
#[derive(Clone, Debug)]
pub struct Tick {
    pub world: (f32, f32, f32),
    /// `None`: the odometry says nothing.
    pub odom: Option<(f32, f32, f32)>,
    /// Of each lidar; `None`: it says nothing.
    pub scans: [Option<Scan>; 3],
}

pub fn tick() -> impl Strategy<Value = Tick> {
    let scan = || prop::option::weighted(0.9, scan());
    let odom = prop::option::weighted(0.9, pose());
    (pose(), odom, [scan(), scan(), scan()]).prop_map(|(world, odom, scans)| Tick { world, odom, scans })
}

const NAMES: [&str; 3] = ["front", "", "rear"];

/// Both maps.
pub struct Pair {
    pub core: LocalGridMap<'static, Vec<u8>>,
    pub std: reference::LocalGridMap,
    beams: Vec<Vec<BeamSlot>>,
}

impl Pair {
    pub fn new(setup: &Setup) -> Self {
        let (external, own) = setup.lidars;
        let lidar = |name| Lidar {
            name,
            mount: Pose2D::default(),
            start_angle: 0.0,
            fov: 0.0,
            max_range: 1.0,
        };
        let own: Vec<_> = NAMES[external..external + own]
            .iter()
            .copied()
            .map(lidar)
            .collect();
        let config = LocalGridMapConfig {
            width: setup.width,
            height: setup.height,
            resolution: setup.resolution,
            include_transformation: true,
            external_lidars: &NAMES[..external],
            external_odometry: if setup.has_odometry { "odom" } else { "" },
            footprint: setup.footprint,
            radius: setup.radius_cells * setup.resolution,
            name: "map",
            lidars: own.leak(),
            odometry: None,
        };
        let cells = vec![77; 60 * 60];
        let std = reference::LocalGridMapConfig {
            width: config.width,
            height: config.height,
            resolution: config.resolution,
            include_transformation: true,
            lidars: config.lidar_names().map(str::to_owned).collect(),
            odometry: None,
            external_odometry: config.external_odometry.to_owned(),
            footprint: match config.footprint {
                Footprint::Rectangular => reference::LocalFootprint::Rectangular,
                Footprint::Circular => reference::LocalFootprint::Circular,
                Footprint::None => reference::LocalFootprint::None,
            },
            radius: config.radius,
            name: config.name.to_owned(),
        };
        Self {
            core: LocalGridMap::new_in(cells, config).unwrap(),
            std: reference::LocalGridMap::try_new(std).unwrap(),
            beams: vec![vec![BeamSlot::EMPTY; BEAMS]; NAMES.len()],
        }
    }

    /// One update of both; everything is compared.
    pub fn tick(&mut self, tick: &Tick) {
        let resolution = self.core.resolution();
        let metres = |(x, y, theta): (f32, f32, f32)| Pose2D::new(x * resolution, y * resolution, theta);
        let mut slots = [BufferSlot::EMPTY; 32];
        let mut floats = [0.0; 1000];
        let mut bytes = [0; 60 * 60];
        let mut state = SensingState::new_in(&mut slots, &mut floats, &mut bytes);
        let mut std_state = reference::SensingState::default();
        let config = *self.core.config();
        if let Some(odom) = tick.odom
            && !config.external_odometry.is_empty()
        {
            let pose = metres(odom);
            let written = Odometry { name: "odom" }.write(&mut state, pose, [0.0; 3]);
            assert_eq!(written.is_ok(), pose.is_finite());
            if written.is_ok() {
                std_state.write_pose("odom", std_pose(pose));
            }
        }
        for (name, scan) in config.lidar_names().zip(&tick.scans) {
            let Some(scan) = scan else { continue };
            let ranges: Vec<_> = scan.ranges.iter().map(|range| range * resolution).collect();
            let mount = metres(scan.mount);
            // An unknown sensor writes what it likes.
            let line = horus_core::local::Shape::line;
            state.write(name, "range", line(ranges.len()), &ranges).unwrap();
            let max_range = scan.max_range * resolution;
            for (field, value) in [
                ("start_angle", scan.start_angle),
                ("fov", scan.fov),
                ("max_range", max_range),
            ] {
                state.write(name, field, line(1), &[value]).unwrap();
            }
            let three = [mount.x, mount.y, mount.theta];
            state.write(name, "mount", line(3), &three).unwrap();
            std_state.write_scan(
                name,
                &reference::LidarScan {
                    mount: std_pose(mount),
                    start_angle: scan.start_angle,
                    fov: scan.fov,
                    max_range,
                    ranges,
                },
            );
        }
        let workspaces = self.beams.iter_mut();
        let mut workspaces: Vec<_> = workspaces
            .map(|slots| ScanWorkspace::new_in(slots, &mut []))
            .collect();
        let world = metres(tick.world);
        let before = self.core.clone();
        let core = self.core.update(&state, world, &mut workspaces);
        let std = self.std.update(&std_state, std_pose(world));
        match (core, std) {
            (Ok(core), Ok(std)) => {
                let told = reference::LocalUpdate {
                    shift: core.shift,
                    missing_odometries: core.missing_odometries,
                    lidars: core.lidars,
                    missing_lidars: core.missing_lidars,
                    empty_lidars: core.empty_lidars,
                    invalid_lidars: core.invalid_lidars,
                    marks: core.marks,
                    ignored: core.ignored,
                };
                assert_eq!(told, std);
                self.compare_transformations(world, core.pose);
            }
            (Err(_), Err(_)) => {
                assert_eq!(
                    self.core.data(),
                    before.data(),
                    "a refused update changes nothing"
                );
                assert_eq!(self.core.offset(), before.offset());
                assert_eq!(self.core.transformation(), before.transformation());
            }
            (core, std) => panic!("core: {core:?}, std: {std:?}"),
        }
        assert_eq!(self.core.offset(), self.std.offset());
        assert_eq!(self.core.origin(), self.std.origin());
        assert_eq!(self.core.data(), self.std.data);
        assert!(self.core.occupancies().eq(self.std.occupancies()));

        self.core.publish(&mut state).unwrap();
        let map = self.core.read_gridmap(&state).unwrap();
        assert_eq!(map.data, self.core.data());
        assert_eq!(
            (map.width, map.height, map.origin),
            (self.core.width(), self.core.height(), self.core.origin())
        );
        let transformation = GridMapView::read_transformation_with_name(&state, "map");
        assert_eq!(transformation, self.core.transformation());
    }

    /// Core's in f32 and the std version's in f64: a few roundings of the largest number involved.
    fn compare_transformations(&self, world: Pose2D, odom: Pose2D) {
        let core = self.core.transformation().unwrap();
        let std = self.std.transformation().unwrap();
        let largest = [world.x, world.y, odom.x, odom.y]
            .iter()
            .fold(1.0f32, |a, b| a.max(b.abs()));
        let turn = world.theta.abs().max(odom.theta.abs()).max(1.0);
        let angle = f64::from(turn) * 3e-7;
        let bound = f64::from(largest) * (angle + 6e-7);
        let metres = [(core.x, std.x), (core.y, std.y)];
        for (core, std) in metres {
            assert!((f64::from(core) - std).abs() <= bound, "{core} {std}");
        }
        let (sin, cos) = (f64::from(core.theta) - std.theta).sin_cos();
        assert!(sin.atan2(cos).abs() <= angle, "{} {}", core.theta, std.theta);
    }
}

pub fn std_pose(pose: Pose2D) -> reference::Pose2D {
    reference::Pose2D::new(pose.x.into(), pose.y.into(), pose.theta.into())
}
