use thiserror::Error;

/// Why the std version refused an input; nothing has changed when one of these is returned.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum ReferenceError {
    /// The resolution of a grid cannot be used.
    #[error("a grid's resolution must be finite and above zero, not {0} m per cell")]
    Resolution(f32),
    /// A pose holds a value that is NaN or infinite, in f64 or once rounded to f32.
    #[error("the {0} must be finite in 32-bit floats")]
    Pose(&'static str),
    /// The grid's cells cannot be counted or allocated.
    #[error("a grid of {width} x {height} cells does not fit into memory")]
    GridSize {
        /// Columns asked for.
        width: u32,
        /// Rows asked for.
        height: u32,
    },
    /// A rolling window would move farther from its first origin than 2^30 cells.
    #[error("the window would lie more than 2^30 cells from its first origin")]
    WindowOffset,
    /// A scan's angle is NaN or infinite, or a range limit is NaN.
    #[error("the scan's {0} is not a usable number")]
    Scan(&'static str),
    /// The steps or limits of an accumulating scan model cannot be used.
    #[error(
        "a scan model needs hit >= 0, miss <= 0 and 0 <= min <= max <= 100, \
         not hit {hit}, miss {miss}, min {min}, max {max}"
    )]
    ScanModel {
        /// Step of a hit cell.
        hit: i8,
        /// Step of a cleared cell.
        miss: i8,
        /// Lower limit.
        min: i8,
        /// Upper limit.
        max: i8,
    },
    /// A cost map parameter is outside its range.
    #[error("{name} must be {expected}, not {value}")]
    CostParam {
        /// The parameter's field name.
        name: &'static str,
        /// Its legal range in words.
        expected: &'static str,
        /// What was given.
        value: f32,
    },
    /// A property of a local map cannot be used.
    #[error("{name} must be {expected}")]
    LocalMap {
        /// The property's name.
        name: &'static str,
        /// Its legal values in words.
        expected: &'static str,
    },
    /// Two lidars of a local map have the same name.
    #[error("two lidars have the same name")]
    DuplicateLidar,
    /// A footprint has too few corners to enclose anything.
    #[error("a footprint needs at least 3 vertices, not {0}")]
    PolygonSize(usize),
    /// A footprint's vertex is NaN or infinite.
    #[error("footprint vertex {0} is not finite")]
    Vertex(usize),
    /// A footprint's vertex lies too far from the map for its cell to be counted.
    #[error("footprint vertex {0} lies more than 2^30 cells from the map's first cell")]
    VertexCell(usize),
}
