/// One side's maps after a tick: what is compared, logged and painted.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct EvidenceLayers {
    /// Whole cells the window has moved since the start, along x and y.
    pub offset: [i32; 2],
    /// Masses free and occupied, row-major.
    pub masses: Vec<[f64; 2]>,
    /// Whether cells are occupied, row-major.
    pub binary: Vec<bool>,
    /// Metres to the nearest occupied cell, row-major.
    pub distance: Vec<f32>,
}
