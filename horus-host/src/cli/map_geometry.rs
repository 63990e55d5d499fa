use horus_core::prelude::Pose2D;
use horus_host::lockstep::LockstepConfig;
use horus_host::log::cost_to_viewable;
use horus_host::log::msg::{Costmap, CostmapMetaData, Header, MapMetaData, OccupancyGrid, Pose, Time};
use horus_host::tf::Pose2;

/// Size and place of a rolling map, and its lethal cost: what logs and pictures need of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MapGeometry {
    pub width: u32,
    pub height: u32,
    pub resolution: f32,
    /// Pose of the corner of cell (0, 0) before the window first moved.
    pub origin: Pose2D,
    pub lethal_cost: u8,
}

impl MapGeometry {
    /// The map of a configuration, with its corner elsewhere.
    pub fn with_origin(config: &LockstepConfig, origin: Pose2D) -> Self {
        Self {
            width: config.width,
            height: config.height,
            resolution: config.resolution,
            origin,
            lethal_cost: config.params.lethal_cost,
        }
    }

    /// Pose of the corner of cell (0, 0) once the window has moved by `offset` whole cells.
    pub fn corner(&self, offset: [i32; 2]) -> Pose2 {
        let metres = offset.map(|cells| f64::from(cells) * f64::from(self.resolution));
        let yaw = f64::from(self.origin.theta);
        let (sin, cos) = libm::sincos(yaw);
        Pose2 {
            x: f64::from(self.origin.x) + (cos * metres[0] - sin * metres[1]),
            y: f64::from(self.origin.y) + (sin * metres[0] + cos * metres[1]),
            yaw,
        }
    }

    /// The map once its window has moved by `offset` whole cells, for messages.
    pub fn at(&self, offset: [i32; 2]) -> PlacedMap {
        let corner = self.corner(offset);
        PlacedMap {
            geometry: *self,
            origin: Pose::planar(corner.x, corner.y, corner.yaw),
        }
    }
}

/// A map where it lies: what a message says of it beside its cells.
#[derive(Debug, Clone, Copy)]
pub struct PlacedMap {
    geometry: MapGeometry,
    origin: Pose,
}

impl PlacedMap {
    /// Occupancy, or any other -1 to 100.
    pub fn occupancy_grid(&self, header: Header, data: Vec<i8>) -> OccupancyGrid {
        OccupancyGrid {
            header,
            info: MapMetaData {
                map_load_time: Time::default(),
                resolution: self.geometry.resolution,
                width: self.geometry.width,
                height: self.geometry.height,
                origin: self.origin,
            },
            data,
        }
    }

    /// Costs as viewers show them.
    pub fn viewable(&self, header: Header, costs: &[u8]) -> OccupancyGrid {
        let lethal = self.geometry.lethal_cost;
        let data = costs.iter().map(|&cost| cost_to_viewable(cost, lethal));
        self.occupancy_grid(header, data.collect())
    }

    /// Exact costs.
    pub fn costmap(&self, header: Header, data: Vec<u8>) -> Costmap {
        Costmap {
            metadata: CostmapMetaData {
                map_load_time: Time::default(),
                update_time: header.stamp,
                layer: "master".to_owned(),
                resolution: self.geometry.resolution,
                size_x: self.geometry.width,
                size_y: self.geometry.height,
                origin: self.origin,
            },
            header,
            data,
        }
    }
}

impl From<&LockstepConfig> for MapGeometry {
    fn from(config: &LockstepConfig) -> Self {
        Self::with_origin(config, config.origin())
    }
}
