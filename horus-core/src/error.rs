//! The one error type of the crate.

use core::fmt;

/// Why an operation was refused. Nothing has changed when one is returned.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Error {
    /// The resolution is not finite or not above zero (metres per cell).
    InvalidResolution(f32),
    /// A pose or a point has a coordinate that is NaN or infinite.
    NonFinitePose,
    /// `width * height` does not fit into the address space.
    SizeOverflow,
    /// A caller-provided buffer is too short.
    BufferTooSmall {
        /// Which buffer.
        buffer: Buffer,
        /// Elements that are needed.
        needed: usize,
        /// Elements that were given.
        given: usize,
    },
    /// A slice has not exactly one element per cell.
    LengthMismatch {
        /// Elements that are needed.
        needed: usize,
        /// Elements that were given.
        given: usize,
    },
    /// The rolling window would leave the range of cell offsets, +-2^30.
    OffsetOutOfRange,
    /// A field of a scan's geometry (angles, range limits) is NaN, or an angle is infinite.
    InvalidScan,
    /// An accumulating scan model has `hit < 0`, `miss > 0`, or not `0 <= min <= max <= 100`.
    InvalidModel,
    /// A cost map parameter is out of its range; the field says which.
    InvalidParameter(Parameter),
    /// Costs above zero reach farther than the field's cells can hold.
    RadiusTooLarge {
        /// Largest radius, in cells, that this field type can hold.
        max_cells: u32,
    },
    /// A budget below the largest single step ([`CostMap::min_budget`](crate::costmap::CostMap::min_budget)).
    BudgetTooSmall {
        /// The smallest legal budget, in cell visits.
        min: u32,
        /// The budget that was given.
        given: u32,
    },
    /// A polygon with fewer than three vertices, or with a vertex that is not finite or is
    /// farther than 2^30 cells away.
    InvalidPolygon,
    /// Belief masses outside 0 to 1, or that do not sum to 1.
    InvalidMasses,
    /// A scan without beams.
    EmptyScan,
    /// No fusion operator has this name.
    UnknownFusionOperator,
    /// A scan names a sensor that there is not.
    UnknownSensor(usize),
    /// A sensor stands outside the fused map.
    SensorOutsideMap(usize),
    /// This type of mass cell is too coarse for the fusion operator.
    UnsupportedFusion,
    /// A window of cells that reaches out of its grid, or whose end lies before its start.
    WindowOutside,
    /// A sensor's or map's name is longer than [`MAX_NAME`](crate::local::MAX_NAME) bytes.
    NameTooLong {
        /// Bytes of the name.
        given: usize,
    },
    /// Two lidars of one map have the same name.
    DuplicateName,
    /// No footprint has this name: `rectangular`, `circular` or `none`.
    UnknownFootprint,
    /// No property has this name.
    UnknownProperty,
    /// A property was given a value of another type, or an integer outside its range.
    PropertyType,
    /// A named buffer holds elements of another type.
    BufferType,
    /// A cost map cannot follow a local map of another size, resolution or first corner.
    GeometryMismatch,
}

/// Bytes that a sensor's or a map's name may have.
pub(crate) const MAX_NAME: usize = 32;

/// The buffer that was too short.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Buffer {
    /// Cell values, one per cell.
    Cells,
    /// The distance field, one per cell.
    Field,
    /// Source and change bits, see [`bit_words`](crate::costmap::bit_words).
    Bits,
    /// Scratch words, see [`scratch_words`](crate::costmap::scratch_words).
    Scratch,
    /// Kept cost bytes, one per cell.
    Costs,
    /// Beam slots, one per beam.
    Beams,
    /// One bit per cell for accumulating scans: a word per 32 cells.
    Seen,
    /// A frame being built, see [`MIN_BUFFER`](crate::frames::MIN_BUFFER).
    Frame,
    /// Classes of a sensor grid, see [`class_bytes`](crate::evidence::class_bytes).
    Classes,
    /// Squared distances, one per cell of the [region](crate::distance::DistanceMap::region).
    Distances,
    /// Vertices of a distance map, one per column, two if signed.
    Vertices,
    /// Slots of named buffers, one per name.
    Slots,
    /// `f32` elements of named buffers.
    Floats,
    /// `u8` elements of named buffers.
    Bytes,
    /// Elements reserved for one named buffer.
    Named,
    /// Scan workspaces, one per lidar.
    Workspaces,
}

/// The parameter that was out of range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Parameter {
    /// `inflation_radius`: finite and >= 0 metres.
    InflationRadius,
    /// `cost_scaling_factor`: finite and >= 0.
    CostScalingFactor,
    /// `lethal_cost`: 2..=254.
    LethalCost,
    /// `lethal_threshold`: 1..=100.
    LethalThreshold,
    /// `inscribed_radius`: finite and >= 0 metres.
    InscribedRadius,
    /// `radius` of a footprint: finite and >= 0 metres.
    FootprintRadius,
    /// `start_angle` of a lidar: finite, radians.
    StartAngle,
    /// `fov` of a lidar: finite, radians.
    FieldOfView,
    /// `max_range` of a lidar: finite and >= 0 metres.
    MaxRange,
    /// `ignorance_floor`: 0 to below 1.
    IgnoranceFloor,
    /// `relative_offset`: finite.
    RelativeOffset,
    /// `wall_thickness`: finite and >= 0 metres.
    WallThickness,
    /// `max_free_range`: >= 0 metres.
    MaxFreeRange,
    /// `beam_half_width`: >= 0 radians.
    BeamHalfWidth,
    /// `free_threshold`: 0 to 1.
    FreeThreshold,
    /// `occupied_threshold`: 0 to 1.
    OccupiedThreshold,
    /// The rectangle of an [`Inpaint`](crate::evidence::Inpaint): finite, each side in order.
    InpaintRectangle,
    /// `max_uncertain`: 0 to 1.
    MaxUncertain,
    /// `max_distance`: above 0 metres.
    MaxDistance,
}

impl Parameter {
    /// The field and its range in words.
    const fn rule(self) -> &'static str {
        match self {
            Self::InflationRadius => "inflation_radius must be finite and not negative",
            Self::CostScalingFactor => "cost_scaling_factor must be finite and not negative",
            Self::LethalCost => "lethal_cost must be 2 to 254",
            Self::LethalThreshold => "lethal_threshold must be 1 to 100",
            Self::InscribedRadius => "inscribed_radius must be finite and not negative",
            Self::FootprintRadius => "radius must be finite and not negative",
            Self::StartAngle => "start_angle must be finite",
            Self::FieldOfView => "fov must be finite",
            Self::MaxRange => "max_range must be finite and not negative",
            Self::IgnoranceFloor => "ignorance_floor must be 0 to below 1",
            Self::RelativeOffset => "relative_offset must be finite",
            Self::WallThickness => "wall_thickness must be finite and not negative",
            Self::MaxFreeRange => "max_free_range must not be negative",
            Self::BeamHalfWidth => "beam_half_width must not be negative",
            Self::FreeThreshold => "free_threshold must be 0 to 1",
            Self::OccupiedThreshold => "occupied_threshold must be 0 to 1",
            Self::InpaintRectangle => "an inpaint rectangle must be finite, its sides in order",
            Self::MaxUncertain => "max_uncertain must be 0 to 1",
            Self::MaxDistance => "max_distance must be above zero",
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::InvalidResolution(r) => {
                write!(f, "resolution {r} m is not finite and above zero")
            }
            Self::NonFinitePose => f.write_str("a pose coordinate is NaN or infinite"),
            Self::SizeOverflow => f.write_str("width * height is too large"),
            Self::BufferTooSmall {
                buffer,
                needed,
                given,
            } => {
                write!(f, "buffer {buffer:?} holds {given} elements, {needed} are needed")
            }
            Self::LengthMismatch { needed, given } => {
                write!(f, "a slice of {given} elements was given for {needed} cells")
            }
            Self::OffsetOutOfRange => f.write_str("the window would move beyond 2^30 cells"),
            Self::InvalidScan => f.write_str("a scan's angle or range limit is not a number"),
            Self::InvalidModel => {
                f.write_str("a scan model needs hit >= 0, miss <= 0 and 0 <= min <= max <= 100")
            }
            Self::InvalidParameter(p) => f.write_str(p.rule()),
            Self::RadiusTooLarge { max_cells } => {
                write!(
                    f,
                    "costs reach beyond {max_cells} cells, the most this field holds"
                )
            }
            Self::BudgetTooSmall { min, given } => {
                write!(f, "a budget of {given} cell visits is below the smallest, {min}")
            }
            Self::InvalidPolygon => f.write_str("a polygon needs three or more finite vertices"),
            Self::InvalidMasses => f.write_str("belief masses must be 0 to 1 and sum to 1"),
            Self::EmptyScan => f.write_str("a scan has no beams"),
            Self::UnknownFusionOperator => {
                f.write_str("a fusion operator is pcr6, dempster_shafer, josang_average or josang_cumulative")
            }
            Self::UnknownSensor(index) => write!(f, "there is no sensor {index}"),
            Self::SensorOutsideMap(index) => write!(f, "sensor {index} stands outside the map"),
            Self::UnsupportedFusion => f.write_str("u8 mass cells take only pcr6 and josang_average"),
            Self::WindowOutside => f.write_str("a window of cells does not lie in its grid"),
            Self::NameTooLong { given } => {
                write!(f, "a name of {given} bytes is longer than {MAX_NAME}")
            }
            Self::DuplicateName => f.write_str("two lidars have the same name"),
            Self::UnknownFootprint => f.write_str("a footprint is rectangular, circular or none"),
            Self::UnknownProperty => f.write_str("no property has this name"),
            Self::PropertyType => f.write_str("a property's value has the wrong type or range"),
            Self::BufferType => f.write_str("a named buffer holds elements of another type"),
            Self::GeometryMismatch => {
                f.write_str("the maps differ in size, resolution or the place of their first corner")
            }
        }
    }
}

impl core::error::Error for Error {}

/// An error unless `given` elements hold `needed`.
pub(crate) fn require(buffer: Buffer, needed: usize, given: usize) -> Result<(), Error> {
    if given < needed {
        Err(Error::BufferTooSmall {
            buffer,
            needed,
            given,
        })
    } else {
        Ok(())
    }
}
