//! The quality-of-service profile a topic was offered with, as rosbag2 stores it in the channel
//! metadata: YAML, enumerations as the integers of `rmw`.

/// Topics a late subscriber still gets the last message of.
const LATCHED: [&str; 2] = ["/map", "/tf_static"];

/// `RMW_DURATION_INFINITE` in seconds and nanoseconds.
const INFINITE: &str = "\n    sec: 9223372036\n    nsec: 854775807\n";

/// The value of `offered_qos_profiles` for `topic`: keep last, reliable, transient local for maps
/// and static transforms, volatile otherwise.
pub(super) fn offered_qos_profiles(topic: &str) -> String {
    let (durability, depth) = if LATCHED.contains(&topic) { (1, 1) } else { (2, 10) };
    format!(
        "- history: 1\n  depth: {depth}\n  reliability: 1\n  durability: {durability}\n  \
         deadline:{INFINITE}  lifespan:{INFINITE}  liveliness: 1\n  \
         liveliness_lease_duration:{INFINITE}  avoid_ros_namespace_conventions: false\n"
    )
}
