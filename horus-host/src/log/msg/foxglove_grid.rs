//! `foxglove_msgs/Grid`: a grid with several named values per cell.
use super::{Pose, Time};

ros_struct! {
    "foxglove_msgs";
    /// A pair of lengths, m.
    #[derive(Copy, Default)]
    pub struct Vector2 {
        /// Along x.
        pub x: f64,
        /// Along y.
        pub y: f64,
    }
}

/// The number types a cell may be packed from, with their codes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum NumericType {
    /// Unsigned byte.
    Uint8 = 1,
    /// 32-bit float.
    Float32 = 7,
}

ros_struct! {
    "foxglove_msgs";
    /// One value of a cell.
    #[derive(Eq, Default)]
    pub struct PackedElementField {
        /// Name of the value, e.g. `occupied`.
        pub name: String,
        /// Bytes from the start of the cell.
        pub offset: u32,
        /// Code of the number type, see [`NumericType`].
        pub r#type: u8,
    }
}

impl PackedElementField {
    /// The value `name`, `offset` bytes into the cell.
    pub fn new(name: &str, offset: u32, numeric_type: NumericType) -> Self {
        Self {
            name: name.to_owned(),
            offset,
            r#type: numeric_type as u8,
        }
    }
}

ros_struct! {
    "foxglove_msgs";
    /// A grid whose cells hold packed values, row-major from the lowest y.
    #[derive(Default)]
    pub struct Grid {
        /// Time of the grid.
        pub timestamp: Time,
        /// Frame of the pose.
        pub frame_id: String,
        /// Pose of the corner of cell (0, 0).
        pub pose: Pose,
        /// Cells along x.
        pub column_count: u32,
        /// Sides of a cell.
        pub cell_size: Vector2,
        /// Bytes from one row to the next.
        pub row_stride: u32,
        /// Bytes from one cell to the next within a row.
        pub cell_stride: u32,
        /// What a cell holds.
        pub fields: Vec<PackedElementField>,
        /// The cells, little endian.
        pub data: Vec<u8>,
    }
}
