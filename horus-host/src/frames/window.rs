/// Moves a window over row-major cells: cell (gx, gy) takes what was at (gx + dx, gy + dy), cells
/// that come into view become `fill`.
pub(super) fn shift(cells: &mut Vec<u8>, width: u32, [dx, dy]: [i64; 2], fill: u8) {
    if [dx, dy] == [0; 2] {
        return;
    }
    let columns = i64::from(width).max(1);
    let rows = cells.len() as i64 / columns;
    let at = |gx: i64, gy: i64| {
        let is_inside = (0..columns).contains(&gx) && (0..rows).contains(&gy);
        let index = usize::try_from(gy * columns + gx).ok().filter(|_| is_inside);
        index.and_then(|i| cells.get(i)).copied().unwrap_or(fill)
    };
    let moved = (0..rows).flat_map(|gy| (0..columns).map(move |gx| (gx, gy)));
    let moved = moved.map(|(gx, gy)| at(gx + dx, gy + dy)).collect();
    *cells = moved;
}
