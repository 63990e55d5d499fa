//! Random drives, core and std version compared after every update.

use horus_core::prelude::Footprint;
use proptest::prelude::*;

use crate::pair::{Pair, Setup, Tick, setup, tick};

proptest! {
    #![proptest_config(ProptestConfig { cases: 800, ..ProptestConfig::default() })]

    #[test]
    fn any_drive(setup in setup(), ticks in prop::collection::vec(tick(), 1..6)) {
        let mut pair = Pair::new(&setup);
        for tick in &ticks {
            pair.tick(tick);
        }
    }

    #[test]
    fn footprints_are_cut_at_every_border(
        width in 1u32..12,
        height in 1u32..12,
        radius_cells in 0.0f32..9.0,
        (x, y) in (-20.0f32..20.0, -20.0f32..20.0),
        circular: bool,
    ) {
        let setup = Setup {
            width,
            height,
            resolution: 0.1,
            footprint: if circular { Footprint::Circular } else { Footprint::Rectangular },
            radius_cells,
            lidars: (0, 0),
            has_odometry: false,
        };
        let mut pair = Pair::new(&setup);
        let tick = Tick { world: (x, y, 0.3), odom: None, scans: [None, None, None] };
        pair.tick(&tick);
        if radius_cells > (width.max(height) + 2) as f32 && !circular {
            prop_assert!(pair.core.data().iter().all(|cell| *cell == 255));
        }
        if radius_cells > width.max(height) as f32 * 0.71 + 2.0 {
            prop_assert!(pair.core.data().iter().all(|cell| *cell == 255), "the corners, too");
        }
    }
}
