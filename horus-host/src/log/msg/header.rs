//! `builtin_interfaces/Time` and `std_msgs/Header`.

/// Nanoseconds in a second.
const NS_PER_S: u64 = 1_000_000_000;

ros_struct! {
    "builtin_interfaces";
    /// A point in time, since the epoch of the log's clock.
    #[derive(Copy, Eq, Default)]
    pub struct Time {
        /// Whole seconds.
        pub sec: i32,
        /// Nanoseconds within the second, below 10^9.
        pub nanosec: u32,
    }
}

impl Time {
    /// The time `ns` nanoseconds after the epoch. Times past the last second an `i32` counts
    /// (early 2038 for Unix time) saturate at it.
    pub fn from_ns(ns: u64) -> Self {
        Self {
            sec: i32::try_from(ns / NS_PER_S).unwrap_or(i32::MAX),
            nanosec: (ns % NS_PER_S) as u32,
        }
    }

    /// Nanoseconds since the epoch; `None` before it.
    pub fn to_ns(self) -> Option<u64> {
        let seconds = u64::try_from(self.sec).ok()?;
        Some(seconds * NS_PER_S + u64::from(self.nanosec))
    }
}

ros_struct! {
    "std_msgs";
    /// When and in which frame the data of a message holds.
    #[derive(Eq, Default)]
    pub struct Header {
        /// Time of the data.
        pub stamp: Time,
        /// Frame the data is given in.
        pub frame_id: String,
    }
}

impl Header {
    /// A header for `frame_id` at `stamp_ns` nanoseconds after the epoch.
    pub fn new(stamp_ns: u64, frame_id: &str) -> Self {
        Self {
            stamp: Time::from_ns(stamp_ns),
            frame_id: frame_id.to_owned(),
        }
    }
}
