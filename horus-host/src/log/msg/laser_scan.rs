//! `sensor_msgs/LaserScan`.
use super::Header;

ros_struct! {
    "sensor_msgs";
    /// One turn of a planar laser scanner.
    #[derive(Default)]
    pub struct LaserScan {
        /// Time of the first beam, and the frame of the scanner.
        pub header: Header,
        /// Angle of the first beam, rad, counter-clockwise from x.
        pub angle_min: f32,
        /// Angle of the last beam, rad.
        pub angle_max: f32,
        /// Angle between beams, rad.
        pub angle_increment: f32,
        /// Time between beams, s.
        pub time_increment: f32,
        /// Time between scans, s.
        pub scan_time: f32,
        /// Shortest valid range, m.
        pub range_min: f32,
        /// Longest valid range, m.
        pub range_max: f32,
        /// Ranges, m: +inf no return, -inf too close, NaN invalid (REP 117).
        pub ranges: Vec<f32>,
        /// Intensities in the device's unit, one per range, or none.
        pub intensities: Vec<f32>,
    }
}
