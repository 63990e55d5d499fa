use horus_host::log::LogMessage;
use horus_host::log::msg::{Costmap, Grid, Message, NumericType, OccupancyGrid, PackedElementField, Pose};
use horus_host::picture::{Cells, Picture, PictureError, Rgb, palette};
use horus_host::tf::Pose2;

/// A grid message of any type, in colours.
pub struct GridPicture {
    pub width: u32,
    pub height: u32,
    /// Metres per cell.
    pub resolution: f64,
    /// Pose of the corner of cell (0, 0).
    pub corner: Pose2,
    pub frame_id: String,
    pub stamp_ns: u64,
    /// The colour that lets through what lies below.
    pub transparent: Option<Rgb>,
    colours: Vec<Rgb>,
    /// A number per cell, in the order of the values.
    order: Vec<i64>,
}

/// Whether messages of this type are grids.
pub fn is_grid(type_name: &str) -> bool {
    [OccupancyGrid::TYPE, Costmap::TYPE, Grid::TYPE].contains(&type_name)
}

impl GridPicture {
    /// Colours the grid in a message; `lethal_cost` is that of exact costs. An occupancy grid shows
    /// costs if its topic says so.
    pub fn of(message: &LogMessage, lethal_cost: u8) -> anyhow::Result<Self> {
        let type_name = message.channel.type_name.as_str();
        let mut picture = if type_name == Costmap::TYPE {
            Self::of_costs(&message.decode()?, lethal_cost)
        } else if type_name == Grid::TYPE {
            Self::of_values(&message.decode()?)?
        } else {
            let shows_costs = message.topic().to_ascii_lowercase().contains("cost");
            Self::of_occupancy(&message.decode()?, shows_costs)
        };
        if picture.stamp_ns == 0 {
            picture.stamp_ns = message.log_time_ns;
        }
        // Checked here, so that painting is only a matter of size.
        Cells::new(picture.width, picture.height, &picture.colours)?;
        Ok(picture)
    }

    /// Paints it, `scale` pixels to a cell.
    pub fn paint(&self, scale: u32) -> Result<Picture, PictureError> {
        Picture::paint(
            Cells::new(self.width, self.height, &self.colours)?,
            scale,
            |colour| colour,
        )
    }

    /// Paints where its values are greater or less than those of `other`.
    pub fn paint_difference(&self, other: &Self, scale: u32) -> Result<Picture, PictureError> {
        let first = Cells::new(self.width, self.height, &self.order)?;
        let second = Cells::new(other.width, other.height, &other.order)?;
        Picture::paint_difference(first, second, scale)
    }

    /// A point in the grid's frame, in cells.
    pub fn cells_of(&self, x: f64, y: f64) -> (f64, f64) {
        let (dx, dy) = (x - self.corner.x, y - self.corner.y);
        let (sin, cos) = libm::sincos(self.corner.yaw);
        (
            (cos * dx + sin * dy) / self.resolution,
            (cos * dy - sin * dx) / self.resolution,
        )
    }

    fn of_occupancy(map: &OccupancyGrid, shows_costs: bool) -> Self {
        let colour = if shows_costs {
            palette::viewable_cost
        } else {
            palette::occupancy
        };
        Self {
            width: map.info.width,
            height: map.info.height,
            resolution: map.info.resolution.into(),
            corner: planar(&map.info.origin),
            frame_id: map.header.frame_id.clone(),
            stamp_ns: map.header.stamp.to_ns().unwrap_or(0),
            transparent: shows_costs.then_some(palette::FREE),
            colours: map.data.iter().map(|&value| colour(value)).collect(),
            order: map.data.iter().map(|&value| value.into()).collect(),
        }
    }

    fn of_costs(map: &Costmap, lethal_cost: u8) -> Self {
        Self {
            width: map.metadata.size_x,
            height: map.metadata.size_y,
            resolution: map.metadata.resolution.into(),
            corner: planar(&map.metadata.origin),
            frame_id: map.header.frame_id.clone(),
            stamp_ns: map.header.stamp.to_ns().unwrap_or(0),
            transparent: Some(palette::FREE),
            colours: map
                .data
                .iter()
                .map(|&cost| palette::cost(cost, lethal_cost))
                .collect(),
            order: map.data.iter().map(|&cost| cost.into()).collect(),
        }
    }

    fn of_values(grid: &Grid) -> anyhow::Result<Self> {
        let (row, cell) = (grid.row_stride as usize, grid.cell_stride as usize);
        let columns = grid.column_count as usize;
        if cell == 0 || columns.checked_mul(cell).is_none_or(|len| len > row) {
            anyhow::bail!("a grid of {columns} columns cannot have rows of {row} bytes and cells of {cell}");
        }
        let field = |name: &str| grid.fields.iter().find(|field| field.name == name);
        let rgb = field("red").zip(field("green")).zip(field("blue"));
        let masses = field("free").zip(field("occupied"));
        let first = grid.fields.first();
        let values: Vec<&[u8]> = grid
            .data
            .chunks_exact(row)
            .flat_map(|row| row.chunks_exact(cell).take(columns))
            .collect();
        let numbers = |field| values.iter().map(move |cell| number(cell, field));
        let farthest = first.map_or(0.0, |field| {
            let finite = numbers(field).filter(|value| value.is_finite());
            finite.fold(0.0f32, |most, value| most.max(value.abs()))
        });
        let colour = |cell: &[u8]| match (rgb, masses, first) {
            (Some(((r, g), b)), ..) => Rgb([r, g, b].map(|field| number(cell, field) as u8)),
            (None, Some((free, occupied)), _) => {
                palette::evidence([free, occupied].map(|field| number(cell, field).into()))
            }
            (None, None, Some(first)) => palette::distance(number(cell, first), farthest),
            (None, None, None) => palette::UNKNOWN,
        };
        // Which value of a cell says most of it.
        let key = field("occupied").or(first);
        let order = |cell: &[u8]| key.map_or(0, |field| ordered(number(cell, field)));
        Ok(Self {
            width: grid.column_count,
            height: u32::try_from(grid.data.len() / row)?,
            resolution: grid.cell_size.x,
            corner: planar(&grid.pose),
            frame_id: grid.frame_id.clone(),
            stamp_ns: grid.timestamp.to_ns().unwrap_or(0),
            transparent: None,
            colours: values.iter().map(|cell| colour(cell)).collect(),
            order: values.iter().map(|cell| order(cell)).collect(),
        })
    }
}

fn planar(pose: &Pose) -> Pose2 {
    Pose2 {
        x: pose.position.x,
        y: pose.position.y,
        yaw: pose.orientation.yaw(),
    }
}

/// A value of a cell; NaN where the cell has none.
fn number(cell: &[u8], field: &PackedElementField) -> f32 {
    let bytes = cell.get(field.offset as usize..).unwrap_or_default();
    match field.r#type {
        code if code == NumericType::Uint8 as u8 => bytes.first().map_or(f32::NAN, |&byte| byte.into()),
        code if code == NumericType::Float32 as u8 => bytes
            .first_chunk()
            .map_or(f32::NAN, |word| f32::from_le_bytes(*word)),
        _ => f32::NAN,
    }
}

/// An integer in the order of floats, negative ones and NaN included.
fn ordered(value: f32) -> i64 {
    let bits = i64::from(value.to_bits());
    if value.is_sign_negative() {
        i64::from(1u32 << 31) - bits
    } else {
        bits
    }
}
