//! The cost under a polygon.

use horus_core::prelude::*;
use proptest::prelude::*;

use crate::pair::{Buffers, Pair, Setup, std_pose};

proptest! {
    #![proptest_config(ProptestConfig { cases: 600, ..ProptestConfig::default() })]

    #[test]
    fn footprints_agree(
        polygon in prop::collection::vec((-1.5f32..1.5, -1.5f32..1.5), 0..9),
        cells in prop::collection::vec((0..40u32, 0..30u32, -1..=100i8), 0..60),
        background in -1..40i8,
        (x, y, theta) in (-2.5f32..2.5, -2.0f32..2.0, -4.0f32..4.0),
        origin_theta in prop_oneof![Just(0.0f32), -4.0f32..4.0],
    ) {
        let origin = Pose2D::new(-2.0, -1.5, origin_theta);
        let params = CostParams::default();
        let setup = Setup { width: 40, height: 30, resolution: 0.1, origin, params };
        let mut buffers = Buffers::<u8>::new(40, 30, false);
        let mut pair = Pair::new(&mut buffers, &setup).unwrap();
        for gy in 0..30 {
            (0..40).for_each(|gx| pair.set(gx, gy, background));
        }
        for (gx, gy, value) in cells {
            pair.set(gx, gy, value);
        }
        pair.core.update_costs();
        pair.check_costs();
        let pose = Pose2D::new(x, y, theta);
        let got = pair.core.footprint_cost(pose, &polygon);
        let expected = pair.oracle.footprint_cost(std_pose(pose), &polygon);
        match (got, expected) {
            (Ok(got), Ok(expected)) => {
                let got = (got.cost, got.touches_unknown, got.leaves_map);
                assert_eq!(got, (expected.cost, expected.touches_unknown, expected.leaves_map));
            }
            (got, expected) => assert_eq!(got.is_err(), expected.is_err(), "{got:?} {expected:?}"),
        }
    }
}

#[test]
fn bad_polygons_are_errors() {
    let origin = Pose2D::default();
    let setup = Setup {
        width: 40,
        height: 30,
        resolution: 0.1,
        origin,
        params: CostParams::default(),
    };
    let mut buffers = Buffers::<u8>::new(40, 30, false);
    let pair = Pair::new(&mut buffers, &setup).unwrap();
    let square = [(0.0, 0.0), (0.5, 0.0), (0.5, 0.5), (0.0, 0.5)];
    let footprint = |pose, polygon: &[(f32, f32)]| pair.core.footprint_cost(pose, polygon);
    assert_eq!(
        footprint(Pose2D::default(), &square[..2]),
        Err(Error::InvalidPolygon)
    );
    for bad in [f32::NAN, f32::INFINITY, 3e38] {
        let polygon = [(0.0, 0.0), (bad, 0.0), (0.5, 0.5)];
        assert_eq!(footprint(Pose2D::default(), &polygon), Err(Error::InvalidPolygon));
        assert!(footprint(Pose2D::new(0.0, bad, 0.0), &square).is_err());
    }
    let unknown = footprint(Pose2D::new(1.0, 1.0, 0.0), &square).unwrap();
    assert_eq!(
        unknown,
        FootprintCost {
            cost: None,
            touches_unknown: true,
            leaves_map: false
        }
    );
}
