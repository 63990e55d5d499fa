use super::frame::BOUNDARY;
use super::{Pose2D, ReferenceError};

/// Cells without a measurement.
pub(super) const UNKNOWN: i8 = -1;

/// A 2D occupancy map: what each cell of a regular grid is believed to hold.
///
/// The fields are public as the message they come from has them. `resolution`, `width`, `height` and the length of
/// `data` belong together: change cells through [`set_occupancy`](Self::set_occupancy), and build a new grid for a
/// new geometry. Where they do not fit each other, cells missing from `data` count as outside the map.
#[derive(Debug, Clone, PartialEq)]
pub struct OccupancyGrid {
    /// Metres per cell.
    pub resolution: f32,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// World pose of the outer corner of cell (0, 0). For reading: [`recenter`](Self::recenter) keeps it current, but
    /// the map itself is placed by the pose it was constructed with and the whole cells it has moved since.
    pub origin: Pose2D,
    /// Cell values, row-major, row 0 at the lowest y: -1 unknown, 0 free to 100 occupied.
    pub data: Vec<i8>,
    /// Name of the coordinate frame, UTF-8, filled with zeros.
    pub frame_id: [u8; 32],
    /// Free-form bytes.
    pub metadata: [u8; 64],
    /// Nanoseconds since the epoch.
    pub timestamp_ns: u64,
    /// The pose given at construction.
    pub(super) origin0: Pose2D,
    /// Whole cells the window has moved since, along the grid's own axes.
    pub(super) offset: [i32; 2],
}

impl OccupancyGrid {
    /// An unknown grid of `width` x `height` cells of `resolution` metres, the corner of cell (0, 0) at `origin`.
    ///
    /// # Panics
    /// Where [`try_new`](Self::try_new) returns an error.
    pub fn new(width: u32, height: u32, resolution: f32, origin: Pose2D) -> Self {
        match Self::try_new(width, height, resolution, origin) {
            Ok(grid) => grid,
            Err(error) => panic!("{error}"),
        }
    }

    /// An unknown grid of `width` x `height` cells of `resolution` metres, the corner of cell (0, 0) at `origin`.
    ///
    /// A grid without cells is legal: every point is outside.
    ///
    /// # Errors
    /// A resolution that is not finite and above zero, an origin that is not finite, more than 2^30 cells on a side
    /// or more than memory holds.
    pub fn try_new(width: u32, height: u32, resolution: f32, origin: Pose2D) -> Result<Self, ReferenceError> {
        if !(resolution.is_finite() && resolution > 0.0) {
            return Err(ReferenceError::Resolution(resolution));
        }
        if origin.to_f32().is_none() {
            return Err(ReferenceError::Pose("grid's origin"));
        }
        let too_large = ReferenceError::GridSize { width, height };
        if width.max(height) > 1 << 30 {
            return Err(too_large);
        }
        let cells = usize::try_from(u64::from(width) * u64::from(height)).or(Err(too_large))?;
        let mut data = Vec::new();
        data.try_reserve_exact(cells).or(Err(too_large))?;
        data.resize(cells, UNKNOWN);
        Ok(Self {
            resolution,
            width,
            height,
            origin,
            data,
            frame_id: [0; 32],
            metadata: [0; 64],
            timestamp_ns: 0,
            origin0: origin,
            offset: [0, 0],
        })
    }

    /// The cell a world point in metres lies in; `None` outside the map and for NaN or infinite coordinates.
    ///
    /// A point on the boundary of two cells belongs to the upper one, the far edge of the map is outside.
    pub fn world_to_grid(&self, x: f64, y: f64) -> Option<(u32, u32)> {
        let (sin, cos) = libm::sincos(self.origin0.theta);
        let (dx, dy) = (x - self.origin0.x, y - self.origin0.y);
        let cell = |local: f64, offset: i32, size: u32| {
            let k = libm::floor(local / f64::from(self.resolution) + f64::from(BOUNDARY));
            let cell = k - f64::from(offset);
            (cell >= 0.0 && cell < f64::from(size)).then_some(cell as u32)
        };
        Some((
            cell(cos * dx + sin * dy, self.offset[0], self.width)?,
            cell(cos * dy - sin * dx, self.offset[1], self.height)?,
        ))
    }

    /// The world position in metres of a cell's centre; `None` outside the map.
    pub fn grid_to_world(&self, gx: u32, gy: u32) -> Option<(f64, f64)> {
        (gx < self.width && gy < self.height)
            .then(|| self.corner_plus(f64::from(gx) + 0.5, f64::from(gy) + 0.5))
    }

    /// A cell's value, -1 unknown or 0 free to 100 occupied; `None` outside the map.
    pub fn occupancy(&self, gx: u32, gy: u32) -> Option<i8> {
        self.index(gx, gy).map(|i| self.data[i])
    }

    /// Sets a cell, clamping `value` to -1..=100; `false`, and nothing changed, outside the map.
    pub fn set_occupancy(&mut self, gx: u32, gy: u32, value: i8) -> bool {
        let index = self.index(gx, gy);
        if let Some(i) = index {
            self.data[i] = value.clamp(UNKNOWN, 100);
        }
        index.is_some()
    }

    /// Whether the cell at a world point in metres is 0 to 49; `false` where it is unknown or outside the map.
    pub fn is_free(&self, x: f64, y: f64) -> bool {
        self.occupancy_at(x, y).is_some_and(|v| (0..50).contains(&v))
    }

    /// Whether the cell at a world point in metres is 50 or more; `false` where it is unknown or outside the map.
    pub fn is_occupied(&self, x: f64, y: f64) -> bool {
        self.occupancy_at(x, y).is_some_and(|v| v >= 50)
    }

    /// The whole cells the window has moved since it was constructed, along the grid's x and y axes.
    pub fn offset(&self) -> [i32; 2] {
        self.offset
    }

    /// The frame's name: the valid UTF-8 before the first zero byte.
    pub fn frame_id_str(&self) -> &str {
        let end = self.frame_id.iter().position(|&b| b == 0);
        let name = &self.frame_id[..end.unwrap_or(self.frame_id.len())];
        name.utf8_chunks().next().map_or("", |chunk| chunk.valid())
    }

    /// Names the frame, cutting `name` to 32 bytes at a character boundary.
    pub fn set_frame_id(&mut self, name: &str) {
        let end = name.floor_char_boundary(self.frame_id.len());
        self.frame_id = [0; 32];
        self.frame_id[..end].copy_from_slice(&name.as_bytes()[..end]);
    }

    /// World position of the point `gx`, `gy` cells from the map's corner, along the grid's axes.
    pub(super) fn corner_plus(&self, gx: f64, gy: f64) -> (f64, f64) {
        let (sin, cos) = libm::sincos(self.origin0.theta);
        let lx = (f64::from(self.offset[0]) + gx) * f64::from(self.resolution);
        let ly = (f64::from(self.offset[1]) + gy) * f64::from(self.resolution);
        (
            self.origin0.x + (cos * lx - sin * ly),
            self.origin0.y + (sin * lx + cos * ly),
        )
    }

    /// Where a cell lies in `data`; `None` outside the map.
    pub(super) fn index(&self, gx: u32, gy: u32) -> Option<usize> {
        let index = gy as usize * self.width as usize + gx as usize;
        (gx < self.width && gy < self.height && index < self.data.len()).then_some(index)
    }

    fn occupancy_at(&self, x: f64, y: f64) -> Option<i8> {
        let (gx, gy) = self.world_to_grid(x, y)?;
        self.occupancy(gx, gy)
    }
}

impl Default for OccupancyGrid {
    /// No cells, of 0.05 m, at the world's origin.
    fn default() -> Self {
        Self::new(0, 0, 0.05, Pose2D::default())
    }
}
