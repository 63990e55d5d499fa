//! `nav_msgs/Path`.
use super::{Header, PoseStamped};

ros_struct! {
    "nav_msgs";
    /// A path to follow.
    #[derive(Default)]
    pub struct Path {
        /// Time of the plan, and its frame.
        pub header: Header,
        /// The poses, in order.
        pub poses: Vec<PoseStamped>,
    }
}
