use super::Rect;

/// What integrating one scan did.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ScanReport {
    /// Smallest rectangle of cells whose value differs from before the scan; `None` if none does.
    pub changed: Option<Rect>,
    /// Beams that ended on something, inside the map or not.
    pub hits: u32,
    /// Beams that reached `range_max`.
    pub misses: u32,
    /// Beams without a usable range, or ending too far away to be counted in cells.
    pub ignored: u32,
}
