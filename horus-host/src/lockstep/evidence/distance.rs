//! Distances by looking around, ring by ring: the same as comparing with every obstacle, in less time where there is a
//! cap.

/// The squared distance in cells from a cell to the nearest one that is set, at most `cap`.
pub(super) fn squared(set: &[bool], width: usize, cell: usize, cap: u32) -> u32 {
    let (x, y) = ((cell % width) as i64, (cell / width) as i64);
    let (columns, rows) = (width as i64, (set.len() / width) as i64);
    let is_set = |dx: i64, dy: i64| {
        let (x, y) = (x + dx, y + dy);
        (0..columns).contains(&x) && (0..rows).contains(&y) && set[(y * columns + x) as usize]
    };
    let mut nearest = u64::from(cap);
    for ring in 0..=columns.max(rows) {
        // Nothing on this ring or beyond is nearer than its sides.
        if (ring * ring) as u64 >= nearest {
            break;
        }
        for along in -ring..=ring {
            let sides = [(along, -ring), (along, ring), (-ring, along), (ring, along)];
            if sides.iter().any(|(dx, dy)| is_set(*dx, *dy)) {
                nearest = nearest.min((ring * ring + along * along) as u64);
            }
        }
    }
    nearest as u32
}

#[cfg(test)]
mod tests {
    use crate::reference::squared_distances;

    #[test]
    fn rings_find_what_brute_force_finds() {
        let mut noise = 9u32;
        for (width, rarity, cap) in [(23, 5, 400), (40, 300, 150), (7, 1000, 60_000)] {
            let set: Vec<bool> = (0..width * 19)
                .map(|_| {
                    noise = noise.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                    (noise >> 8).is_multiple_of(rarity)
                })
                .collect();
            let rings: Vec<u32> = (0..set.len())
                .map(|i| super::squared(&set, width, i, cap))
                .collect();
            assert_eq!(rings, squared_distances(&set, width, cap));
        }
    }
}
