//! The distance of every cell to the nearest obstacle in its own column (for an obstacle of a signed map: to the
//! nearest cell that is none), row by row: down from the first row, then up from the last.

use super::DistanceCell;

/// The first row: nothing is known of what lies before or after it.
pub(super) fn first<D: DistanceCell>(row: &mut [D], obstacles: impl Iterator<Item = bool>) {
    for (cell, obstacle) in row.iter_mut().zip(obstacles) {
        *cell = D::new(obstacle, D::NONE);
    }
}

/// A row after the one before it.
pub(super) fn down<D: DistanceCell>(row: &mut [D], before: &[D], obstacles: impl Iterator<Item = bool>) {
    for ((cell, before), obstacle) in row.iter_mut().zip(before).zip(obstacles) {
        *cell = D::beside(obstacle, *before);
    }
}

/// The way back: a row before the one after it.
pub(super) fn up<D: DistanceCell>(row: &mut [D], after: &[D]) {
    for (cell, after) in row.iter_mut().zip(after) {
        *cell = cell.nearer(D::beside(cell.is_obstacle(), *after));
    }
}

/// What lies `distance` rows beyond a row at the edge of a window.
pub(super) fn beyond<D: DistanceCell>(row: &mut [D], distance: u32, obstacles: impl Iterator<Item = bool>) {
    for (cell, obstacle) in row.iter_mut().zip(obstacles) {
        if obstacle != cell.is_obstacle() {
            *cell = cell.nearer(D::new(cell.is_obstacle(), distance));
        }
    }
}
