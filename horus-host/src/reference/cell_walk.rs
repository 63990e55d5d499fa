//! The cell walks of Beluga, step by step as its documentation words them.

/// The cells of Beluga's standard walk between two cells, both included.
///
/// x is dominant where its side is at least as long. The error starts at the dominant side and gains twice the minor
/// side per step; above twice the dominant side it loses that, and the minor axis moves.
pub fn standard_walk(from: [i32; 2], to: [i32; 2]) -> Vec<[i32; 2]> {
    beluga(from, to, false)
}

/// The cells of Beluga's supercover walk: the standard one, and before a cell that both axes have moved to, the cell
/// that the line passes on the way, or both where it runs through the corner.
pub fn supercover_walk(from: [i32; 2], to: [i32; 2]) -> Vec<[i32; 2]> {
    beluga(from, to, true)
}

fn beluga(from: [i32; 2], to: [i32; 2], supercover: bool) -> Vec<[i32; 2]> {
    let delta = [0, 1].map(|axis| i64::from(to[axis]) - i64::from(from[axis]));
    let dominant = usize::from(delta[0].abs() < delta[1].abs());
    let minor = 1 - dominant;
    let span = delta[dominant].abs();
    let moved = |cell: [i32; 2], axis: usize| {
        let mut cell = cell;
        cell[axis] += delta[axis].signum() as i32;
        cell
    };
    let mut cells = vec![from];
    let (mut cell, mut err) = (from, span);
    for _ in 0..span {
        let (before, previous) = (cell, err);
        cell = moved(cell, dominant);
        err += 2 * delta[minor].abs();
        if err > 2 * span {
            err -= 2 * span;
            if supercover && previous + err <= 2 * span {
                cells.push(moved(before, dominant));
            }
            if supercover && previous + err >= 2 * span {
                cells.push(moved(before, minor));
            }
            cell = moved(cell, minor);
        }
        cells.push(cell);
    }
    cells
}
