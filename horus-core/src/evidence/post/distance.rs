use super::BinaryMap;
use crate::distance::{DistanceCell, DistanceMap, DistanceOptions, Regions};
use crate::error::Error;
use crate::geometry::CellRect;

/// Starts computing the distances of all cells of a binary map to the nearest occupied one: reads it,
/// and leaves the rest to [`DistanceMap::advance`]. With a signed cell type distances are computed
/// inside obstacles, too: Isaac's `compute_distance_inside`.
///
/// Distances are exact up to `max_distance` metres, rounded up to whole squared cells, or to what `D`
/// can hold, and that cap beyond. `resolution` is metres per cell.
///
/// Source: Isaac `BinaryMapToDistanceMap`.
///
/// # Errors
/// [`Error::SizeOverflow`] if a side exceeds [`MAX_SIDE`](crate::distance::MAX_SIDE);
/// [`Error::BufferTooSmall`]. The distances stay as they were.
///
/// # Complexity
/// Two cell visits per cell.
pub fn binary_to_distance<D: DistanceCell>(
    binary: &BinaryMap<'_>,
    resolution: f32,
    max_distance: f32,
    distance: &mut DistanceMap<'_, D>,
) -> Result<(), Error> {
    let whole = CellRect {
        x0: 0,
        y0: 0,
        x1: binary.width(),
        y1: binary.height(),
    };
    let place = Regions {
        size: [binary.width(), binary.height()],
        window: whole,
        region: whole,
    };
    let options = DistanceOptions::default().with_max_distance(max_distance, resolution);
    distance.begin_rows(place, resolution, options, |gy| binary.row(gy))
}
