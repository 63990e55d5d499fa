use horus_core::prelude::{Error, GridInfo, OccupancyGrid, Pose2D};
use iceoryx2::prelude::ZeroCopySend;

use super::kind::{Counted, Plain};

/// Bytes of a frame's name; longer names are cut at a character.
const FRAME_LEN: usize = 32;

/// Size and place of a grid: what precedes its cells.
#[derive(Debug, Clone, Copy, PartialEq, ZeroCopySend)]
#[repr(C)]
pub struct GridHeader {
    /// Nanoseconds since the epoch of its sender.
    pub timestamp_ns: u64,
    /// x, y in metres and heading in radians of the corner of cell (0, 0), in the frame `frame_id`.
    pub origin: [f64; 3],
    /// Metres per cell.
    pub resolution: f32,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Zero.
    pub reserved: u32,
    /// Name of the frame, UTF-8, zero-filled.
    pub frame_id: [u8; FRAME_LEN],
    /// Free-form text, UTF-8, zero-filled.
    pub metadata: [u8; 64],
}

/// What precedes the cells of a local grid map: a [`GridHeader`] under another name, by which topics tell
/// its bytes from costs.
#[derive(Debug, Clone, Copy, Default, PartialEq, ZeroCopySend)]
#[repr(C)]
pub struct LocalGridHeader {
    /// Size and place.
    pub grid: GridHeader,
}

/// What precedes the ranges of a laser scan.
#[derive(Debug, Clone, Copy, Default, PartialEq, ZeroCopySend)]
#[repr(C)]
pub struct ScanHeader {
    /// Nanoseconds since the epoch of its sender.
    pub timestamp_ns: u64,
    /// Angle of the first beam, rad.
    pub angle_min: f32,
    /// Angle between beams, rad.
    pub angle_increment: f32,
    /// Shortest valid range, m.
    pub range_min: f32,
    /// Longest valid range, m.
    pub range_max: f32,
    /// Time between beams, s.
    pub time_increment: f32,
    /// Time between scans, s.
    pub scan_time: f32,
    /// Number of beams.
    pub beams: u32,
    /// Zero.
    pub reserved: u32,
    /// Name of the sensor's frame, UTF-8, zero-filled.
    pub frame_id: [u8; FRAME_LEN],
}

/// What precedes transforms.
#[derive(Debug, Clone, Copy, Default, PartialEq, ZeroCopySend)]
#[repr(C)]
pub struct TransformHeader {
    /// Nanoseconds since the epoch of its sender.
    pub timestamp_ns: u64,
    /// Number of transforms.
    pub count: u32,
    /// 1 if they hold for all times.
    pub is_static: u32,
}

/// Where a frame stands in its parent.
#[derive(Debug, Clone, Copy, Default, PartialEq, ZeroCopySend)]
#[repr(C)]
pub struct TransformEntry {
    /// Nanoseconds since the epoch of its sender.
    pub timestamp_ns: u64,
    /// Name of the parent frame, UTF-8, zero-filled.
    pub parent: [u8; FRAME_LEN],
    /// Name of the child frame, UTF-8, zero-filled.
    pub child: [u8; FRAME_LEN],
    /// x, y, z, metres.
    pub translation: [f64; 3],
    /// Quaternion x, y, z, w.
    pub rotation: [f64; 4],
}

impl Default for GridHeader {
    fn default() -> Self {
        Self {
            timestamp_ns: 0,
            origin: [0.0; 3],
            resolution: 0.0,
            width: 0,
            height: 0,
            reserved: 0,
            frame_id: [0; FRAME_LEN],
            metadata: [0; 64],
        }
    }
}

// SAFETY: numbers and bytes, in an order without padding (`headers_have_no_padding`).
unsafe impl Plain for GridHeader {}
// SAFETY: as above.
unsafe impl Plain for LocalGridHeader {}
// SAFETY: as above.
unsafe impl Plain for ScanHeader {}
// SAFETY: as above.
unsafe impl Plain for TransformHeader {}
// SAFETY: as above.
unsafe impl Plain for TransformEntry {}

impl Counted for GridHeader {
    fn count(&self) -> usize {
        usize::try_from(u64::from(self.width) * u64::from(self.height)).unwrap_or(usize::MAX)
    }
}

impl Counted for LocalGridHeader {
    fn count(&self) -> usize {
        self.grid.count()
    }
}

impl Counted for ScanHeader {
    fn count(&self) -> usize {
        self.beams as usize
    }
}

impl Counted for TransformHeader {
    fn count(&self) -> usize {
        self.count as usize
    }
}

impl GridHeader {
    /// The header of a core grid, as its window lies now.
    pub fn of<S: AsRef<[i8]>>(grid: &OccupancyGrid<S>) -> Self {
        Self {
            timestamp_ns: grid.timestamp_ns,
            frame_id: grid.frame_id,
            metadata: grid.metadata,
            ..Self::of_info(grid.info())
        }
    }

    /// The header of any map of this size and place.
    pub fn of_info(info: &GridInfo) -> Self {
        let origin = info.origin();
        Self {
            origin: [origin.x, origin.y, origin.theta].map(f64::from),
            resolution: info.resolution(),
            width: info.width(),
            height: info.height(),
            ..Self::default()
        }
    }

    /// The cells of a message as a core grid.
    ///
    /// # Errors
    /// As [`OccupancyGrid::view`]: a sender of another program may send anything.
    pub fn view<'a>(&self, cells: &'a [i8]) -> Result<OccupancyGrid<&'a [i8]>, Error> {
        let [x, y, theta] = self.origin.map(|value| value as f32);
        let mut grid = OccupancyGrid::view(
            cells,
            self.width,
            self.height,
            self.resolution,
            Pose2D::new(x, y, theta),
        )?;
        grid.timestamp_ns = self.timestamp_ns;
        grid.frame_id = self.frame_id;
        grid.metadata = self.metadata;
        Ok(grid)
    }
}

/// A frame's name as it stands in headers: cut at a character, zero-filled.
pub fn frame_bytes(name: &str) -> [u8; FRAME_LEN] {
    let mut bytes = [0; FRAME_LEN];
    let mut len = name.len().min(FRAME_LEN);
    while !name.is_char_boundary(len) {
        len -= 1;
    }
    for (byte, character) in bytes.iter_mut().zip(name.bytes().take(len)) {
        *byte = character;
    }
    bytes
}

/// The name in a header; what is no UTF-8 is replaced.
pub fn frame_name(bytes: &[u8]) -> String {
    let end = bytes.iter().position(|&byte| byte == 0).unwrap_or(bytes.len());
    String::from_utf8_lossy(bytes.get(..end).unwrap_or_default()).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headers_have_no_padding() {
        assert_eq!(size_of::<GridHeader>(), 8 + 24 + 4 * 4 + 32 + 64);
        assert_eq!(size_of::<LocalGridHeader>(), size_of::<GridHeader>());
        assert_eq!(size_of::<ScanHeader>(), 8 + 6 * 4 + 4 + 4 + 32);
        assert_eq!(size_of::<TransformHeader>(), 8 + 4 + 4);
        assert_eq!(size_of::<TransformEntry>(), 8 + 2 * 32 + 7 * 8);
    }

    #[test]
    fn frames_are_cut_at_a_character() {
        assert_eq!(frame_name(&frame_bytes("base_link")), "base_link");
        let long = format!("{}é", "a".repeat(31));
        assert_eq!(frame_name(&frame_bytes(&long)), "a".repeat(31));
        assert_eq!(frame_name(&[0xff, 0]), "\u{fffd}");
    }
}
