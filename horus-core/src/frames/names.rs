/// The names of the coordinate frames in a log; each is cut to 32 bytes of whole characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameNames<'a> {
    /// The frame the map lies in.
    pub odom: &'a str,
    /// The robot.
    pub base: &'a str,
    /// The lidar.
    pub sensor: &'a str,
}

impl Default for FrameNames<'_> {
    /// `odom`, `base_link`, `laser`.
    fn default() -> Self {
        Self {
            odom: "odom",
            base: "base_link",
            sensor: "laser",
        }
    }
}
