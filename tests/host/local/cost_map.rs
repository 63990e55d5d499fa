//! A cost map that follows a local map.

use horus_core::costmap::{CostTables, FieldCell, bit_words, scratch_words};
use horus_core::prelude::*;
use proptest::prelude::*;

use crate::pair::{Pair, Setup, setup, tick};

/// Shows a cost map of this size over buffers on the heap to `test`.
fn with_map<F: FieldCell + 'static, R>(
    setup: &Setup,
    (params, kept): (CostParams, bool),
    tables: &mut CostTables<F>,
    test: impl FnOnce(&mut CostMap<'_, F>) -> R,
) -> R {
    let Setup { width, height, .. } = *setup;
    let cells = (width * height) as usize;
    let (mut occupancy, mut field) = (vec![0; cells], vec![F::ZERO; cells]);
    let (mut bits, mut scratch) = (vec![0; bit_words(width, height)], vec![0; scratch_words(15)]);
    let mut costs = kept.then(|| vec![0; cells]);
    let grid = OccupancyGrid::new_in(
        &mut occupancy[..],
        width,
        height,
        setup.resolution,
        Pose2D::default(),
    );
    let buffers = CostBuffers {
        bits: &mut bits,
        field: &mut field,
        scratch: &mut scratch,
        costs: costs.as_deref_mut(),
        tables,
    };
    test(&mut CostMap::new_in(grid.unwrap(), buffers, params).unwrap())
}

fn costs<F: FieldCell>(map: &CostMap<'_, F>) -> Vec<u8> {
    (0..map.info().height()).flat_map(|gy| map.row(gy)).collect()
}

/// A cost map computed in full from the local map's values.
fn full(setup: &Setup, params: CostParams, local: &LocalGridMap<'_, Vec<u8>>) -> Vec<u8> {
    let values: Vec<_> = local.occupancies().collect();
    let mut tables = CostTables::<u8>::EMPTY;
    with_map(setup, (params, false), &mut tables, |map| {
        map.load(&values).unwrap();
        costs(map)
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, ..ProptestConfig::default() })]

    #[test]
    fn follows_any_drive(
        setup in setup(),
        ticks in prop::collection::vec((tick(), any::<bool>()), 1..6),
        kept: bool,
        unknown_inflates: bool,
    ) {
        let params = CostParams { unknown_inflates, ..CostParams::default() }
            .with_radius(3.0 * setup.resolution);
        let mut pair = Pair::new(&setup);
        let mut tables = CostTables::<u8>::EMPTY;
        with_map(&setup, (params, kept), &mut tables, |map| {
            for (tick, follow) in &ticks {
                pair.tick(tick);
                if !follow {
                    continue; // it need not follow every update
                }
                pair.core.update_cost_map(map).unwrap();
                assert!(pair.core.occupancies().eq(map.occupancy_grid().data().iter().copied()));
                assert_eq!(map.info().offset(), pair.core.offset());
                map.update_costs();
                let expected = full(&setup, params, &pair.core);
                assert_eq!(costs(map), expected);
                assert!(map.costs().is_none_or(|kept| kept == expected));
                pair.core.update_cost_map(map).unwrap();
                assert_eq!((map.pending(), map.update_costs()), (0, None), "nothing has changed");
            }
        });
    }
}

#[test]
fn only_net_changes_arrive() {
    let setup = Setup {
        width: 60,
        height: 60,
        resolution: 0.05,
        footprint: Footprint::Rectangular,
        radius_cells: 2.0,
        lidars: (1, 0),
        has_odometry: false,
    };
    let wall = crate::pair::Scan {
        mount: (0.0, 0.0, 0.0),
        start_angle: -0.5,
        fov: 1.0,
        max_range: 60.0,
        ranges: vec![20.0; 39],
    };
    let tick = crate::pair::Tick {
        world: (0.2, 0.1, 0.0),
        odom: None,
        scans: [Some(wall), None, None],
    };
    let mut pair = Pair::new(&setup);
    let params = CostParams::default().with_radius(0.2);
    let mut tables = CostTables::<u16>::EMPTY;
    with_map(&setup, (params, false), &mut tables, |map| {
        pair.tick(&tick);
        pair.core.update_cost_map(map).unwrap();
        assert!(map.update_costs().is_some());
        // Every cell of the wall is cleared by neighbouring rays and marked again.
        pair.tick(&tick);
        pair.core.update_cost_map(map).unwrap();
        assert_eq!(map.pending(), 0);
        assert_eq!(map.update_costs(), None);
    });
}

#[test]
fn another_geometry_is_refused() {
    let setup = Setup {
        width: 20,
        height: 10,
        resolution: 0.05,
        footprint: Footprint::None,
        radius_cells: 0.0,
        lidars: (0, 0),
        has_odometry: false,
    };
    let pair = Pair::new(&setup);
    let others = [
        Setup {
            width: 10,
            height: 20,
            ..setup.clone()
        },
        Setup {
            resolution: 0.06,
            ..setup.clone()
        },
    ];
    for other in others {
        let params = CostParams::default().with_radius(0.2);
        let mut tables = CostTables::<u8>::EMPTY;
        with_map(&other, (params, false), &mut tables, |map| {
            assert_eq!(pair.core.update_cost_map(map), Err(Error::GeometryMismatch));
            assert!(map.occupancy_grid().data().iter().all(|cell| *cell == -1));
        });
    }
}
