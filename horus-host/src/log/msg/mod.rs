//! The ROS 2 messages a log holds, as plain structures named and ordered like their definitions.
//!
//! Each structure is written down once, as a field list; its encoding, its decoding, its `ros2msg`
//! definition and its field-by-field comparison all follow from that list, so they cannot drift
//! apart.
#[macro_use]
mod ros_struct;

mod costmap;
mod foxglove_grid;
mod geometry;
mod header;
mod laser_scan;
mod message;
mod occupancy_grid;
mod path;
mod tf_message;

pub use costmap::{Costmap, CostmapMetaData};
pub use foxglove_grid::{Grid, NumericType, PackedElementField, Vector2};
pub use geometry::{Point, Pose, PoseStamped, Quaternion, Transform, TransformStamped, Vector3};
pub use header::{Header, Time};
pub use laser_scan::LaserScan;
pub use message::Message;
pub use occupancy_grid::{MapMetaData, OccupancyGrid};
pub use path::Path;
pub use tf_message::TFMessage;

#[cfg(test)]
mod tests;
