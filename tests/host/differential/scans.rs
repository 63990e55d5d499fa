//! Scans far outside, and from far away.

use horus_core::grid::ScanModel;
use horus_core::prelude::*;
use proptest::prelude::*;

use crate::op::{Scan, scan};
use crate::pair::{Buffers, Pair, Setup};

fn pair_on<R>(resolution: f32, origin: Pose2D, test: impl FnOnce(&mut Pair<'_, u8>) -> R) -> R {
    let setup = Setup {
        width: 40,
        height: 30,
        resolution,
        origin,
        params: CostParams::default().with_radius(0.2),
    };
    let mut buffers = Buffers::<u8>::new(40, 30, false);
    test(&mut Pair::new(&mut buffers, &setup).unwrap())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 600, ..ProptestConfig::default() })]

    #[test]
    fn sensors_anywhere(scans in prop::collection::vec(scan(), 1..4), far in -1e5f32..1e5, resolution in 0.01f32..0.5) {
        pair_on(resolution, Pose2D::new(-1.0, -1.0, 0.4), |pair| {
            for (i, scan) in scans.iter().enumerate() {
                let x = if i == 1 { far } else { scan.x };
                pair.scan(&Scan { x, ..scan.clone() });
                pair.check_cells();
            }
        });
    }

    #[test]
    fn points_agree_away_from_boundaries(x in -3.0f64..3.0, y in -3.0f64..3.0, theta in -4.0f32..4.0) {
        let origin = Pose2D::new(-1.0, -0.7, theta);
        pair_on(0.05, origin, |pair| {
            let grid = &pair.oracle.occupancy_grid;
            let near = |d: f64| {
                let around = [(d, 0.0), (-d, 0.0), (0.0, d), (0.0, -d)];
                around.map(|(dx, dy)| grid.world_to_grid(x + dx, y + dy))
            };
            // Farther than 2e-3 cell from a boundary the cell is the same all around.
            let expected = grid.world_to_grid(x, y);
            if near(2.0e-3 * 0.05 * 1.5).iter().all(|cell| *cell == expected) {
                assert_eq!(pair.core.occupancy_grid().world_to_grid(x as f32, y as f32), expected);
            }
        });
    }
}

#[test]
fn a_cleared_and_marked_cell_has_not_changed() {
    pair_on(0.1, Pose2D::new(-2.0, -1.5, 0.0), |pair| {
        let wall = Scan {
            x: 0.05,
            y: 0.05,
            theta: 0.0,
            angle_min: -0.5,
            angle_increment: 0.02,
            ranges: vec![1.0; 51],
            model: ScanModel::Set,
        };
        pair.scan(&wall);
        pair.core.update_costs();
        pair.scan(&wall); // the report's rectangle, compared inside, is empty now
        assert_eq!(pair.core.update_costs(), None);
    });
}
