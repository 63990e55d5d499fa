//! Exact distances by looking from every cell at every other.

/// For every cell the squared distance, in cells, to the nearest cell that is set in `mask`, at most `cap`.
///
/// `mask` is row-major with rows of `width` cells.
pub fn squared_distances(mask: &[bool], width: usize, cap: u32) -> Vec<u32> {
    let place = |i: usize| ((i % width) as i64, (i / width) as i64);
    let set: Vec<_> = (0..mask.len()).filter(|i| mask[*i]).map(place).collect();
    let nearest = |cell: usize| {
        let (x, y) = place(cell);
        let squared = set.iter().map(|(ox, oy)| (x - ox).pow(2) + (y - oy).pow(2));
        squared.min().map_or(cap, |d| d.min(cap.into()) as u32)
    };
    (0..mask.len()).map(nearest).collect()
}

/// The signed squares: as [`squared_distances`] for cells that are not set; minus the squared distance to the nearest
/// one that is not set, at most `cap`, for those that are.
pub fn signed_squared_distances(mask: &[bool], width: usize, cap: u32) -> Vec<i64> {
    let clear: Vec<bool> = mask.iter().map(|set| !set).collect();
    let outside = squared_distances(mask, width, cap);
    let inside = squared_distances(&clear, width, cap);
    let both = outside.into_iter().zip(inside);
    both.map(|(out, inn)| i64::from(out) - i64::from(inn)).collect()
}
