//! `geometry_msgs`: the types poses and transforms are made of.
use super::Header;

ros_struct! {
    "geometry_msgs";
    /// A point, in metres.
    #[derive(Copy, Default)]
    pub struct Point {
        /// Forward.
        pub x: f64,
        /// Left.
        pub y: f64,
        /// Up.
        pub z: f64,
    }
}

ros_struct! {
    "geometry_msgs";
    /// A free vector, in metres where it is a translation.
    #[derive(Copy, Default)]
    pub struct Vector3 {
        /// Forward.
        pub x: f64,
        /// Left.
        pub y: f64,
        /// Up.
        pub z: f64,
    }
}

ros_struct! {
    "geometry_msgs";
    /// A rotation as a unit quaternion; the default is no rotation.
    #[derive(Copy)]
    pub struct Quaternion {
        /// Coefficient of i.
        pub x: f64,
        /// Coefficient of j.
        pub y: f64,
        /// Coefficient of k.
        pub z: f64,
        /// Scalar part.
        pub w: f64,
    }
}

impl Default for Quaternion {
    fn default() -> Self {
        Self {
            x: 0.0,
            y: 0.0,
            z: 0.0,
            w: 1.0,
        }
    }
}

impl Quaternion {
    /// The rotation by `yaw` rad about z, counter-clockwise.
    pub fn from_yaw(yaw: f64) -> Self {
        // libm, not std: the same log must have the same bytes on every platform.
        Self {
            x: 0.0,
            y: 0.0,
            z: libm::sin(0.5 * yaw),
            w: libm::cos(0.5 * yaw),
        }
    }

    /// Yaw in rad, -pi..=pi: the heading of the rotated x axis in the x-y plane.
    pub fn yaw(&self) -> f64 {
        let Self { x, y, z, w } = self;
        libm::atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))
    }
}

ros_struct! {
    "geometry_msgs";
    /// Where something stands and how it is turned.
    #[derive(Copy, Default)]
    pub struct Pose {
        /// Position, m.
        pub position: Point,
        /// Orientation.
        pub orientation: Quaternion,
    }
}

impl Pose {
    /// The pose at (`x`, `y`) m in the plane, turned by `yaw` rad.
    pub fn planar(x: f64, y: f64, yaw: f64) -> Self {
        Self {
            position: Point { x, y, z: 0.0 },
            orientation: Quaternion::from_yaw(yaw),
        }
    }
}

ros_struct! {
    "geometry_msgs";
    /// The pose of a child frame in its parent frame.
    #[derive(Copy, Default)]
    pub struct Transform {
        /// Origin of the child, m.
        pub translation: Vector3,
        /// Axes of the child.
        pub rotation: Quaternion,
    }
}

impl Transform {
    /// The transform with translation (`x`, `y`) m in the plane and rotation by `yaw` rad.
    pub fn planar(x: f64, y: f64, yaw: f64) -> Self {
        Self {
            translation: Vector3 { x, y, z: 0.0 },
            rotation: Quaternion::from_yaw(yaw),
        }
    }
}

ros_struct! {
    "geometry_msgs";
    /// A pose with its time and frame.
    #[derive(Default)]
    pub struct PoseStamped {
        /// Time and frame of the pose.
        pub header: Header,
        /// The pose.
        pub pose: Pose,
    }
}

ros_struct! {
    "geometry_msgs";
    /// A transform from `child_frame_id` to the header's frame, at the header's time.
    #[derive(Default)]
    pub struct TransformStamped {
        /// Time, and the parent frame.
        pub header: Header,
        /// The child frame.
        pub child_frame_id: String,
        /// Pose of the child in the parent.
        pub transform: Transform,
    }
}
