use core::ffi::{CStr, c_char};

use crate::error::{Buffer, Error, Parameter};

/// Whether a call did what it was asked to. Anything but HORUS_STATUS_OK: nothing has changed and
/// nothing was written, unless the function says otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum horus_status {
    /// Done.
    Ok = 0,
    /// A pointer is NULL.
    NullPointer = 1,
    /// A pointer is not aligned for what it points to; memory for an object: to HORUS_ALIGN.
    Misaligned = 2,
    /// Two of the call's pointers reach the same memory, or one reaches into an object's memory.
    Overlap = 3,
    /// Not an object of this kind: never initialised, of another kind, moved, or overwritten.
    InvalidHandle = 4,
    /// A size or a length is beyond the address space, or a grid would have 2^32 - 1 cells or more.
    SizeOverflow = 5,
    /// The memory or a buffer is too short; for an object, its `bytes` function tells the length.
    BufferTooSmall = 6,
    /// An array has not exactly one element per cell.
    LengthMismatch = 7,
    /// The cell or the point lies outside the grid, or the point is not finite.
    Outside = 8,
    /// A number is none of the named constants (decay, kind of scan model, bytes per field cell).
    InvalidChoice = 9,
    /// A text is not UTF-8.
    InvalidText = 10,
    /// The cost map keeps no cost bytes.
    NotKept = 11,
    /// The resolution is not finite or not above zero.
    InvalidResolution = 12,
    /// A coordinate of a pose is NaN or infinite.
    NonFinitePose = 13,
    /// The window would move beyond 2^30 cells.
    OffsetOutOfRange = 14,
    /// An angle of the scan is not finite, or a range limit is NaN.
    InvalidScan = 15,
    /// The scan model needs hit >= 0, miss <= 0 and 0 <= min <= max <= 100.
    InvalidModel = 16,
    /// The workspace has too few beams for the scan or, accumulating, too few cells for the grid.
    WorkspaceTooSmall = 17,
    /// inflation_radius must be finite and not negative.
    InvalidInflationRadius = 18,
    /// cost_scaling_factor must be finite and not negative.
    InvalidCostScalingFactor = 19,
    /// lethal_cost must be 2 to 254.
    InvalidLethalCost = 20,
    /// lethal_threshold must be 1 to 100.
    InvalidLethalThreshold = 21,
    /// inscribed_radius must be finite and not negative.
    InvalidInscribedRadius = 22,
    /// Costs reach farther than the field can hold: 15 cells with one byte, 255 with two.
    RadiusTooLarge = 23,
    /// The budget is below horus_cost_map_min_budget().
    BudgetTooSmall = 24,
    /// A polygon needs three or more finite vertices within 2^30 cells.
    InvalidPolygon = 25,
    /// A name is longer than 32 bytes.
    NameTooLong = 26,
    /// Two lidars of a local map have the same name.
    DuplicateName = 27,
    /// A footprint's radius must be finite and not negative.
    InvalidFootprintRadius = 28,
    /// A lidar's angles must be finite, its longest range finite and not negative.
    InvalidLidar = 29,
    /// A cost map cannot follow a local map of another size, resolution or first corner.
    GeometryMismatch = 30,
    /// Nothing of this name was written, or something else.
    NotFound = 31,
    /// Belief masses must be 0 to 1 and sum to at most 1.
    InvalidMasses = 32,
    /// A scan has no beams.
    EmptyScan = 33,
    /// There is no sensor of this index.
    UnknownSensor = 34,
    /// The sensor stands outside the map.
    SensorOutsideMap = 35,
    /// A threshold, floor, thickness, width, range, rectangle or distance of a local mapping is out of
    /// its range.
    InvalidMappingParameter = 36,
}

use horus_status as Status;

/// Every status at the place of its number.
const ALL: [Status; 37] = [
    Status::Ok,
    Status::NullPointer,
    Status::Misaligned,
    Status::Overlap,
    Status::InvalidHandle,
    Status::SizeOverflow,
    Status::BufferTooSmall,
    Status::LengthMismatch,
    Status::Outside,
    Status::InvalidChoice,
    Status::InvalidText,
    Status::NotKept,
    Status::InvalidResolution,
    Status::NonFinitePose,
    Status::OffsetOutOfRange,
    Status::InvalidScan,
    Status::InvalidModel,
    Status::WorkspaceTooSmall,
    Status::InvalidInflationRadius,
    Status::InvalidCostScalingFactor,
    Status::InvalidLethalCost,
    Status::InvalidLethalThreshold,
    Status::InvalidInscribedRadius,
    Status::RadiusTooLarge,
    Status::BudgetTooSmall,
    Status::InvalidPolygon,
    Status::NameTooLong,
    Status::DuplicateName,
    Status::InvalidFootprintRadius,
    Status::InvalidLidar,
    Status::GeometryMismatch,
    Status::NotFound,
    Status::InvalidMasses,
    Status::EmptyScan,
    Status::UnknownSensor,
    Status::SensorOutsideMap,
    Status::InvalidMappingParameter,
];

const _: () = {
    let mut i = 0;
    while i < ALL.len() {
        assert!(ALL[i] as usize == i, "ALL is in the order of the numbers");
        i += 1;
    }
};

impl horus_status {
    /// The status as a sentence.
    const fn text(self) -> &'static CStr {
        match self {
            Self::Ok => c"done",
            Self::NullPointer => c"a pointer is NULL",
            Self::Misaligned => c"a pointer is not aligned",
            Self::Overlap => c"two pointers of a call reach the same memory",
            Self::InvalidHandle => c"not an initialised object of this kind",
            Self::SizeOverflow => {
                c"a size or a length is beyond the address space, or there are 2^32 - 1 cells or more"
            }
            Self::BufferTooSmall => c"the memory or a buffer is too short",
            Self::LengthMismatch => c"an array has not exactly one element per cell",
            Self::Outside => c"the cell, the point or the window lies outside the grid",
            Self::InvalidChoice => c"a number is none of the named constants",
            Self::InvalidText => c"a text is not UTF-8",
            Self::NotKept => c"the cost map keeps no cost bytes",
            Self::InvalidResolution => c"the resolution is not finite and above zero",
            Self::NonFinitePose => c"a pose coordinate is NaN or infinite",
            Self::OffsetOutOfRange => c"the window would move beyond 2^30 cells",
            Self::InvalidScan => c"a scan's angle or range limit is not a number",
            Self::InvalidModel => c"a scan model needs hit >= 0, miss <= 0 and 0 <= min <= max <= 100",
            Self::WorkspaceTooSmall => c"the workspace has too few beams or cells",
            Self::InvalidInflationRadius => c"inflation_radius must be finite and not negative",
            Self::InvalidCostScalingFactor => c"cost_scaling_factor must be finite and not negative",
            Self::InvalidLethalCost => c"lethal_cost must be 2 to 254",
            Self::InvalidLethalThreshold => c"lethal_threshold must be 1 to 100",
            Self::InvalidInscribedRadius => c"inscribed_radius must be finite and not negative",
            Self::RadiusTooLarge => c"costs reach farther than the field can hold",
            Self::BudgetTooSmall => c"the budget is below the smallest",
            Self::InvalidPolygon => c"a polygon needs three or more finite vertices",
            Self::NameTooLong => c"a name is longer than 32 bytes",
            Self::DuplicateName => c"two lidars have the same name",
            Self::InvalidFootprintRadius => c"a footprint's radius must be finite and not negative",
            Self::InvalidLidar => {
                c"a lidar's angles must be finite, its longest range finite and not negative"
            }
            Self::GeometryMismatch => {
                c"the maps differ in size, resolution or the place of their first corner"
            }
            Self::NotFound => c"nothing of this name was written, or something else",
            Self::InvalidMasses => c"belief masses must be 0 to 1 and sum to at most 1",
            Self::EmptyScan => c"a scan has no beams",
            Self::UnknownSensor => c"there is no sensor of this index",
            Self::SensorOutsideMap => c"the sensor stands outside the map",
            Self::InvalidMappingParameter => c"a parameter of local mapping is out of its range",
        }
    }
}

impl From<Error> for horus_status {
    fn from(error: Error) -> Self {
        match error {
            Error::InvalidResolution(_) => Self::InvalidResolution,
            Error::NonFinitePose => Self::NonFinitePose,
            Error::SizeOverflow => Self::SizeOverflow,
            Error::BufferTooSmall {
                buffer: Buffer::Beams | Buffer::Seen | Buffer::Workspaces,
                ..
            } => Self::WorkspaceTooSmall,
            Error::BufferTooSmall { .. } => Self::BufferTooSmall,
            Error::LengthMismatch { .. } => Self::LengthMismatch,
            Error::OffsetOutOfRange => Self::OffsetOutOfRange,
            Error::InvalidScan => Self::InvalidScan,
            Error::InvalidModel => Self::InvalidModel,
            Error::InvalidParameter(parameter) => match parameter {
                Parameter::InflationRadius => Self::InvalidInflationRadius,
                Parameter::CostScalingFactor => Self::InvalidCostScalingFactor,
                Parameter::LethalCost => Self::InvalidLethalCost,
                Parameter::LethalThreshold => Self::InvalidLethalThreshold,
                Parameter::InscribedRadius => Self::InvalidInscribedRadius,
                Parameter::FootprintRadius => Self::InvalidFootprintRadius,
                Parameter::StartAngle | Parameter::FieldOfView | Parameter::MaxRange => Self::InvalidLidar,
                Parameter::IgnoranceFloor
                | Parameter::RelativeOffset
                | Parameter::WallThickness
                | Parameter::MaxFreeRange
                | Parameter::BeamHalfWidth
                | Parameter::FreeThreshold
                | Parameter::OccupiedThreshold
                | Parameter::InpaintRectangle
                | Parameter::MaxUncertain
                | Parameter::MaxDistance => Self::InvalidMappingParameter,
            },
            Error::RadiusTooLarge { .. } => Self::RadiusTooLarge,
            Error::BudgetTooSmall { .. } => Self::BudgetTooSmall,
            Error::InvalidPolygon => Self::InvalidPolygon,
            Error::WindowOutside => Self::Outside,
            Error::NameTooLong { .. } => Self::NameTooLong,
            Error::DuplicateName => Self::DuplicateName,
            Error::UnknownFootprint | Error::UnknownProperty | Error::PropertyType => Self::InvalidChoice,
            Error::BufferType => Self::NotFound,
            Error::GeometryMismatch => Self::GeometryMismatch,
            Error::InvalidMasses => Self::InvalidMasses,
            Error::EmptyScan => Self::EmptyScan,
            Error::UnknownSensor(_) => Self::UnknownSensor,
            Error::SensorOutsideMap(_) => Self::SensorOutsideMap,
            Error::UnknownFusionOperator | Error::UnsupportedFusion => Self::InvalidChoice,
        }
    }
}

/// What was asked for lies inside, or the status that says it does not.
pub(super) fn inside<T>(found: Option<T>) -> Result<T, horus_status> {
    found.ok_or(horus_status::Outside)
}

/// A status as a short English sentence, for ever; any number is legal.
#[unsafe(no_mangle)]
pub extern "C" fn horus_status_text(status: i32) -> *const c_char {
    let status = usize::try_from(status).ok().and_then(|i| ALL.get(i));
    status.map_or(c"not a status", |status| status.text()).as_ptr()
}
