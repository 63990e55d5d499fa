use horus_core::local::{GridMapView, Shape};
use horus_core::prelude::*;
use horus_host::reference;

use super::storage::LIDARS;
use super::{LocalCase, LocalOp, LocalStorage, Sensor};
use crate::compare::{agreed, same_cells};
use crate::scene::{BEAMS, Place, std_pose};

const ODOMETRY: [&str; 2] = ["wheels", "odom"];

/// A local map of core and one of the std version that have seen the same.
pub struct LocalPair<'a> {
    core: LocalGridMap<'a, Vec<u8>>,
    std: reference::LocalGridMap,
    state: SensingState<'a>,
    std_state: reference::SensingState,
    /// They remember their beams' directions from one update to the next.
    workspaces: Vec<ScanWorkspace<'a>>,
    costs: CostMap<'a>,
}

impl<'a> LocalPair<'a> {
    /// Two maps of unknown cells; `None` if both refuse the configuration.
    pub fn new(case: &LocalCase, storage: &'a mut LocalStorage) -> Option<Self> {
        let [width, height] = storage.size;
        let resolution = case.resolution.0;
        let footprints = [
            (Footprint::Rectangular, reference::LocalFootprint::Rectangular),
            (Footprint::Circular, reference::LocalFootprint::Circular),
            (Footprint::None, reference::LocalFootprint::None),
        ];
        let (footprint, std_footprint) = footprints[usize::from(case.footprint % 3)];
        let [others, odometry] = case.odometry;
        let config = LocalGridMapConfig {
            width,
            height,
            resolution,
            include_transformation: true,
            external_lidars: &LIDARS[..storage.external],
            external_odometry: if others { ODOMETRY[1] } else { "" },
            footprint,
            radius: case.radius.of(resolution),
            name: "map",
            lidars: &storage.own,
            odometry: odometry.then_some(Odometry { name: ODOMETRY[0] }),
        };
        let std = reference::LocalGridMap::try_new(reference::LocalGridMapConfig {
            width,
            height,
            resolution,
            include_transformation: true,
            lidars: config.lidar_names().map(str::to_owned).collect(),
            odometry: odometry.then(|| ODOMETRY[0].to_owned()),
            external_odometry: config.external_odometry.to_owned(),
            footprint: std_footprint,
            radius: config.radius,
            name: "map".to_owned(),
        });
        let cells = (width * height) as usize;
        let core = LocalGridMap::new_in(vec![7; cells], config);
        let (core, std) = agreed("new_in", core, std)?;
        let state = SensingState::new_in(&mut storage.slots, &mut storage.floats, &mut storage.bytes);
        let occupancy = &mut storage.occupancy[..];
        let grid = OccupancyGrid::new_in(occupancy, width, height, resolution, Pose2D::default());
        let buffers = CostBuffers {
            bits: &mut storage.bits,
            field: &mut storage.field,
            scratch: &mut storage.scratch,
            costs: Some(&mut storage.costs),
            tables: &mut storage.tables,
        };
        let beams = storage.beams.iter_mut();
        let params = CostParams::default().with_radius(3.0 * resolution);
        Some(Self {
            core,
            std,
            state,
            std_state: reference::SensingState::default(),
            workspaces: beams.map(|slots| ScanWorkspace::new_in(slots, &mut [])).collect(),
            costs: CostMap::new_in(grid.ok()?, buffers, params).ok()?,
        })
    }

    /// Does the same to both and compares everything.
    pub fn apply(&mut self, op: &LocalOp) {
        let resolution = self.core.resolution();
        match op {
            LocalOp::Scan(sensor) => self.sense(sensor),
            LocalOp::Odometry(which, place) => self.odometry(ODOMETRY[usize::from(*which)], *place),
            LocalOp::ClearState => {
                self.state.clear();
                self.std_state.buffers.clear();
            }
            LocalOp::Update(place, few) => self.update(place.pose(resolution), *few),
            LocalOp::Recenter(place) => {
                let pose = place.pose(resolution);
                let (core, std) = (self.core.recenter(pose), self.std.recenter(std_pose(pose)));
                if let Some((core, std)) = agreed("recenter", core, std) {
                    assert_eq!(core, std);
                }
            }
            LocalOp::Load(value) => {
                let values = vec![*value; self.core.info().cells()];
                self.core.load(&values).expect("one value per cell");
                let value = self.core.data().first().copied();
                self.std.data.fill(value.unwrap_or(128));
            }
            LocalOp::Publish => self.publish(),
            LocalOp::Follow => self.follow(),
        }
        assert_eq!(self.core.offset(), self.std.offset(), "offset");
        assert_eq!(self.core.origin(), self.std.origin(), "origin");
        same_cells("cells", self.core.data(), &self.std.data, self.core.width());
    }

    fn sense(&mut self, sensor: &Sensor) {
        let resolution = self.core.resolution();
        let name = LIDARS[usize::from(sensor.which) % LIDARS.len()];
        let ranges: Vec<_> = sensor.ranges.0.iter().map(|range| range.of(resolution)).collect();
        let mount = sensor.mount.map(|place| place.pose(resolution));
        let mount = mount.map(|pose| vec![pose.x, pose.y, pose.theta]);
        let fields = [
            ("range", ranges, BEAMS),
            ("start_angle", vec![sensor.start_angle.of(0.1)], 1),
            ("fov", vec![sensor.fov.of(0.1)], 1),
            ("max_range", vec![sensor.max_range.of(resolution)], 1),
            ("mount", mount.unwrap_or_default(), 3),
        ];
        for (i, (field, values, capacity)) in fields.into_iter().enumerate() {
            if i == usize::from(sensor.left_out % 8) {
                continue; // what was written before stays
            }
            self.state.reserve::<f32>(name, field, capacity).expect("room");
            let shape = Shape::line(values.len());
            self.state.write(name, field, shape, &values).expect("reserved");
            let key = if name.is_empty() {
                field.to_owned()
            } else {
                format!("{name}/{field}")
            };
            let buffer = reference::SensingBuffer::F32(values);
            self.std_state.buffers.insert(key, buffer);
        }
    }

    fn odometry(&mut self, name: &'static str, place: Place) {
        let pose = place.pose(self.core.resolution());
        let written = Odometry { name }.write(&mut self.state, pose, [0.0; 3]);
        assert_eq!(written.is_ok(), pose.is_finite());
        if written.is_ok() {
            self.std_state.write_pose(name, std_pose(pose));
        }
    }

    fn update(&mut self, pose: Pose2D, few: bool) {
        let lidars = self.core.config().lidar_names().count();
        let before = (self.core.data().to_vec(), self.core.offset());
        if few && lidars > 0 {
            let refused = self
                .core
                .update(&self.state, pose, &mut self.workspaces[..lidars - 1]);
            assert!(refused.is_err());
            assert_eq!(before, (self.core.data().to_vec(), self.core.offset()));
            return;
        }
        let core = self.core.update(&self.state, pose, &mut self.workspaces);
        let std = self.std.update(&self.std_state, std_pose(pose));
        match agreed("update", core, std) {
            Some((core, std)) => {
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
            }
            None => assert_eq!(before, (self.core.data().to_vec(), self.core.offset())),
        }
    }

    fn publish(&mut self) {
        self.core.publish(&mut self.state).expect("room");
        let map = self.core.read_gridmap(&self.state).expect("published");
        assert_eq!((map.data, map.origin), (self.core.data(), self.core.origin()));
        if let Some(transformation) = self.core.transformation() {
            let read = GridMapView::read_transformation_with_name(&self.state, "map");
            let bits = |pose: Pose2D| [pose.x, pose.y, pose.theta].map(f32::to_bits);
            assert_eq!(read.map(bits), Some(bits(transformation)));
        }
    }

    fn follow(&mut self) {
        self.core
            .update_cost_map(&mut self.costs)
            .expect("the same geometry");
        assert!(
            self.core
                .occupancies()
                .eq(self.costs.occupancy_grid().data().iter().copied())
        );
        assert_eq!(self.costs.info().offset(), self.core.offset());
        self.costs.update_costs();
        let kept = self.costs.costs().map(<[u8]>::to_vec);
        self.costs.compute_costs();
        assert_eq!(kept.as_deref(), self.costs.costs(), "incremental and full costs");
    }
}
