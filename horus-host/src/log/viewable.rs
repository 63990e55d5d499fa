/// Cost of an unknown cell.
const UNKNOWN: u8 = 255;

/// Maps a cost onto the -1..=100 of an occupancy grid, as viewers show cost maps.
///
/// Free 0 -> 0, `lethal` -> 100, other costs from 253 -> 99, unknown 255 -> -1, and what lies
/// between spreads over 1..=98: `1 + 97 * (cost - 1) / 251`, rounded down.
pub fn cost_to_viewable(cost: u8, lethal: u8) -> i8 {
    match cost {
        0 => 0,
        UNKNOWN => -1,
        _ if cost == lethal => 100,
        253.. => 99,
        // At most 98, so the cast is exact.
        _ => (1 + 97 * (u16::from(cost) - 1) / 251) as i8,
    }
}

#[cfg(test)]
mod tests {
    use super::cost_to_viewable;

    #[test]
    fn named_costs_and_the_ends_of_the_slope() {
        for (cost, lethal, viewable) in [
            (0, 253, 0),
            (1, 253, 1),
            (127, 253, 49),
            (252, 253, 98),
            (253, 253, 100),
            (254, 253, 99),
            (255, 253, -1),
            (252, 254, 98),
            (253, 254, 99),
            (254, 254, 100),
            (255, 254, -1),
            (100, 100, 100),
            (99, 100, 38),
        ] {
            assert_eq!(cost_to_viewable(cost, lethal), viewable, "{cost} of {lethal}");
        }
    }

    #[test]
    fn a_higher_cost_never_looks_lower() {
        let shown: Vec<i8> = (0..=253).map(|cost| cost_to_viewable(cost, 253)).collect();
        assert!(shown.is_sorted());
    }
}
