//! `nav2_msgs/Costmap`.
use super::{Header, Pose, Time};

ros_struct! {
    "nav2_msgs";
    /// Size and place of a cost map.
    #[derive(Default)]
    pub struct CostmapMetaData {
        /// Time the underlying map was loaded.
        pub map_load_time: Time,
        /// Time of the last update.
        pub update_time: Time,
        /// Name of the layer, e.g. `master`.
        pub layer: String,
        /// Side of a cell, m.
        pub resolution: f32,
        /// Cells along x.
        pub size_x: u32,
        /// Cells along y.
        pub size_y: u32,
        /// Pose of the corner of cell (0, 0) in the header's frame.
        pub origin: Pose,
    }
}

ros_struct! {
    "nav2_msgs";
    /// A map of exact costs, which an occupancy grid cannot carry.
    #[derive(Default)]
    pub struct Costmap {
        /// Time of the map, and the frame of its origin.
        pub header: Header,
        /// Size and place.
        pub metadata: CostmapMetaData,
        /// `size_x * size_y` costs, row-major from the lowest y: 0 to 254, 255 unknown.
        pub data: Vec<u8>,
    }
}
