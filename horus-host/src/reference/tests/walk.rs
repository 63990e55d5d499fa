use super::super::{walk_cell, walk_inside, walk_steps};
use super::Numbers;

/// The same walk as the systems it comes from write it: one step at a time, with an error term.
fn stepwise(from: [i32; 2], to: [i32; 2]) -> Vec<[i64; 2]> {
    let delta = [0, 1].map(|a| i64::from(to[a]) - i64::from(from[a]));
    let (major, minor) = if delta[0].abs() >= delta[1].abs() {
        (0, 1)
    } else {
        (1, 0)
    };
    let mut cell = from.map(i64::from);
    let mut error = delta[major].abs() / 2;
    let mut cells = vec![cell];
    for _ in 0..delta[major].abs() {
        cell[major] += delta[major].signum();
        error += delta[minor].abs();
        if error >= delta[major].abs() {
            cell[minor] += delta[minor].signum();
            error -= delta[major].abs();
        }
        cells.push(cell);
    }
    cells
}

#[test]
fn the_closed_form_takes_the_cells_of_the_error_term() {
    let mut numbers = Numbers(1);
    for _ in 0..2000 {
        let [from, to] = [(); 2].map(|()| [(); 2].map(|()| numbers.below(41) as i32 - 20));
        let steps = 0..=walk_steps(from, to);
        let cells: Vec<_> = steps.map(|i| walk_cell(from, to, i)).collect();
        assert_eq!(cells, stepwise(from, to), "{from:?} to {to:?}");
        assert_eq!(cells.last(), Some(&to.map(i64::from)));

        let (width, height) = (numbers.below(12), numbers.below(12));
        let inside: Vec<_> = walk_inside(from, to, width, height)
            .map(|(step, cell)| (step, cell.map(i64::from)))
            .collect();
        let is_inside =
            |c: &[i64; 2]| (0..i64::from(width)).contains(&c[0]) && (0..i64::from(height)).contains(&c[1]);
        let expected: Vec<_> = (0..).zip(cells).filter(|(_, c)| is_inside(c)).collect();
        assert_eq!(inside, expected, "{from:?} to {to:?} in {width} x {height}");
    }
}

#[test]
fn equal_sides_walk_along_x_and_ties_step_early() {
    assert_eq!(walk_cell([0, 0], [2, 1], 1), [1, 1]);
    assert_eq!(walk_cell([0, 0], [-1, -2], 1), [-1, -1]);
    assert_eq!(walk_cell([0, 0], [3, 3], 2), [2, 2]);
    assert_eq!(walk_cell([7, 7], [7, 7], 0), [7, 7]);
}

#[test]
fn a_walk_across_the_world_costs_no_more_than_the_map_is_long() {
    let far = 1 << 30;
    let cells: Vec<_> = walk_inside([-far, -far], [far, far], 5, 3).collect();
    let step = i64::from(far);
    assert_eq!(cells, [0, 1, 2].map(|k| (step + i64::from(k), [k, k])));
    assert_eq!(walk_inside([far, 9], [-far, 9], 5, 3).count(), 0);
    assert_eq!(walk_inside([i32::MIN, 0], [i32::MAX, 0], 5, 3).count(), 5);
}
