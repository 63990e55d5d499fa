//! `tf2_msgs/TFMessage`.
use super::TransformStamped;

ros_struct! {
    "tf2_msgs";
    /// Edges of the transform tree.
    #[derive(Default)]
    pub struct TFMessage {
        /// The transforms, each with a time of its own.
        pub transforms: Vec<TransformStamped>,
    }
}
