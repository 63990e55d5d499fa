//! `nav_msgs/OccupancyGrid`.
use super::{Header, Pose, Time};

ros_struct! {
    "nav_msgs";
    /// Size and place of a map.
    #[derive(Default)]
    pub struct MapMetaData {
        /// Time the map was loaded.
        pub map_load_time: Time,
        /// Side of a cell, m.
        pub resolution: f32,
        /// Cells along x.
        pub width: u32,
        /// Cells along y.
        pub height: u32,
        /// Pose of the corner of cell (0, 0) in the header's frame.
        pub origin: Pose,
    }
}

ros_struct! {
    "nav_msgs";
    /// A map of occupancy probabilities.
    #[derive(Default)]
    pub struct OccupancyGrid {
        /// Time of the map, and the frame of its origin.
        pub header: Header,
        /// Size and place.
        pub info: MapMetaData,
        /// `width * height` cells, row-major from the lowest y: 0 to 100 per cent, -1 unknown.
        pub data: Vec<i8>,
    }
}
