//! The integer cell walk of navground and nav2, in closed form.

/// Number of steps of the walk between two cells: the longer of its two sides.
pub fn walk_steps(from: [i32; 2], to: [i32; 2]) -> i64 {
    let side = |axis: usize| (i64::from(to[axis]) - i64::from(from[axis])).abs();
    side(0).max(side(1))
}

/// The cell after `step` steps of the walk between two cells; step 0 is `from`, step [`walk_steps`] is `to`.
///
/// Every step moves one cell along the dominant axis, which is x where the two sides are equal. An error term starts
/// at half the dominant side (rounded down), gains the minor side in each step, and moves the minor axis whenever it
/// reaches the dominant side, so after `i` steps the minor axis has moved `floor((n/2 + i * m) / n)` cells.
pub fn walk_cell(from: [i32; 2], to: [i32; 2], step: i64) -> [i64; 2] {
    let start = from.map(i64::from);
    let delta = [i64::from(to[0]) - start[0], i64::from(to[1]) - start[1]];
    let dominant = dominant_axis(from, to);
    let minor = 1 - dominant;
    let (n, m) = (delta[dominant].abs(), delta[minor].abs());
    if n == 0 {
        return start;
    }
    let mut cell = start;
    cell[dominant] += delta[dominant].signum() * step;
    cell[minor] += delta[minor].signum() * ((n / 2 + step * m) / n);
    cell
}

/// The cells of the walk that lie inside a map, in walking order, each with its step number.
///
/// The rest of the walk is not stepped through: only steps whose dominant coordinate lies inside the map are looked
/// at, so the work is bounded by the map's longer side.
pub fn walk_inside(
    from: [i32; 2],
    to: [i32; 2],
    width: u32,
    height: u32,
) -> impl Iterator<Item = (i64, [u32; 2])> {
    let axis = dominant_axis(from, to);
    let start = i64::from(from[axis]);
    let last = i64::from([width, height][axis]) - 1;
    // Steps at which the dominant coordinate runs from 0 to `last`, or back.
    let (first_step, last_step) = if to[axis] >= from[axis] {
        (-start, last - start)
    } else {
        (start - last, start)
    };
    let steps = first_step.max(0)..=last_step.min(walk_steps(from, to));
    steps.filter_map(move |step| {
        let [x, y] = walk_cell(from, to, step).map(u32::try_from);
        let cell = [x.ok()?, y.ok()?];
        (cell[0] < width && cell[1] < height).then_some((step, cell))
    })
}

/// 0 where the walk is at least as long in x as in y, else 1.
fn dominant_axis(from: [i32; 2], to: [i32; 2]) -> usize {
    usize::from(to[0].abs_diff(from[0]) < to[1].abs_diff(from[1]))
}
