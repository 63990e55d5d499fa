//! What core says to input that it cannot use: a typed error, and nothing has changed.

use horus_core::costmap::{CostTables, bit_words, scratch_words};
use horus_core::error::{Buffer, Parameter};
use horus_core::prelude::*;

const SIDE: u32 = 20;
const CELLS: usize = 400;
const BAD: [f32; 3] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];

/// Lengths of a cost map's buffers.
#[derive(Clone, Copy)]
struct Lengths {
    bits: usize,
    field: usize,
    scratch: usize,
    costs: usize,
}

impl Lengths {
    fn enough() -> Self {
        Self {
            bits: bit_words(SIDE, SIDE),
            field: CELLS,
            scratch: scratch_words(15),
            costs: CELLS,
        }
    }
}

/// Makes a cost map with buffers of these lengths and shows it to `test`.
fn with_map<R>(
    lengths: Lengths,
    params: CostParams,
    test: impl FnOnce(Result<CostMap<'_>, Error>) -> R,
) -> R {
    let mut cells = vec![0; CELLS];
    let (mut bits, mut field) = (vec![0; lengths.bits], vec![0u8; lengths.field]);
    let (mut scratch, mut costs) = (vec![0; lengths.scratch], vec![0; lengths.costs]);
    let mut tables = CostTables::EMPTY;
    let grid = OccupancyGrid::new_in(&mut cells[..], SIDE, SIDE, 0.05, Pose2D::default()).unwrap();
    let buffers = CostBuffers {
        bits: &mut bits,
        field: &mut field,
        scratch: &mut scratch,
        costs: Some(&mut costs),
        tables: &mut tables,
    };
    test(CostMap::new_in(grid, buffers, params))
}

#[test]
fn storage_that_is_too_small() {
    let short = [(0u32, 1u32), (1, 0), (1, 1), (20, 21), (21, 20), (1 << 30, 1)];
    for (width, height) in short {
        let needed = width as usize * height as usize;
        let mut cells = [7i8; 400];
        let grid = OccupancyGrid::new_in(&mut cells[..], width, height, 0.1, Pose2D::default());
        let expected = Error::BufferTooSmall {
            buffer: Buffer::Cells,
            needed,
            given: 400,
        };
        assert_eq!(grid.err(), (needed > 400).then_some(expected));
    }
    let enough = Lengths::enough();
    let one_less = [
        (
            Buffer::Bits,
            Lengths {
                bits: enough.bits - 1,
                ..enough
            },
        ),
        (
            Buffer::Field,
            Lengths {
                field: CELLS - 1,
                ..enough
            },
        ),
        (
            Buffer::Scratch,
            Lengths {
                scratch: enough.scratch - 1,
                ..enough
            },
        ),
        (
            Buffer::Costs,
            Lengths {
                costs: CELLS - 1,
                ..enough
            },
        ),
    ];
    for (short, lengths) in one_less {
        with_map(lengths, CostParams::default(), |map| {
            let error = map.err();
            assert!(
                matches!(error, Some(Error::BufferTooSmall { buffer, .. }) if buffer == short),
                "{error:?}"
            );
        });
    }
    with_map(enough, CostParams::default(), |map| assert!(map.is_ok()));
}

#[test]
fn sizes_and_places_that_cannot_be() {
    let new = |w, h, res, x, theta| OccupancyGrid::view(&[], w, h, res, Pose2D::new(x, 0.0, theta)).err();
    for bad in [0.0, -0.05, f32::NAN, f32::INFINITY] {
        assert!(matches!(
            new(0, 0, bad, 0.0, 0.0),
            Some(Error::InvalidResolution(_))
        ));
    }
    for bad in BAD {
        assert_eq!(new(0, 0, 0.1, bad, 0.0), Some(Error::NonFinitePose));
        assert_eq!(new(0, 0, 0.1, 0.0, bad), Some(Error::NonFinitePose));
    }
    assert_eq!(new(u32::MAX, u32::MAX, 0.1, 0.0, 0.0), Some(Error::SizeOverflow));
    assert_eq!(new((1 << 30) + 1, 1, 0.1, 0.0, 0.0), Some(Error::SizeOverflow));
    // A cell index fits 32 bits.
    assert_eq!(new(1 << 16, 1 << 16, 0.1, 0.0, 0.0), Some(Error::SizeOverflow));
    assert_eq!(new(0, 0, 0.1, 0.0, 0.0), None, "0 x 0 is legal");
}

#[test]
fn a_failed_reset_changes_nothing() {
    let mut grid = StaticOccupancyGrid::<9>::empty();
    assert_eq!((grid.width(), grid.world_to_grid(0.0, 0.0)), (0, None));
    assert_eq!(grid.recenter(Pose2D::new(5.0, 5.0, 0.0)), Ok([0, 0]));
    grid.reset(3, 3, 1.0, Pose2D::default()).unwrap();
    grid.set_occupancy(1, 1, 100);
    grid.set_frame_id("map");
    assert!(grid.reset(4, 3, 1.0, Pose2D::default()).is_err());
    assert!(grid.reset(3, 3, 0.0, Pose2D::default()).is_err());
    assert_eq!((grid.occupancy(1, 1), grid.frame_id_str()), (Some(100), "map"));
    assert_eq!(
        grid.load(&[0; 8]),
        Err(Error::LengthMismatch { needed: 9, given: 8 })
    );
    assert_eq!(grid.occupancy(1, 1), Some(100));
}

#[test]
fn points_poses_and_scans_that_are_no_numbers() {
    let mut cells = [0i8; 9];
    let mut grid = OccupancyGrid::new_in(&mut cells[..], 3, 3, 1.0, Pose2D::default()).unwrap();
    let (mut slots, ranges) = ([BeamSlot::EMPTY; 4], [1.0; 4]);
    let mut lidar = ScanWorkspace::new_in(&mut slots, &mut []);
    let good = LaserScan {
        angle_min: 0.0,
        angle_increment: 0.1,
        range_min: 0.1,
        range_max: 2.0,
        ranges: &ranges,
    };
    let middle = Pose2D::new(1.5, 1.5, 0.0);
    for bad in BAD {
        assert_eq!(grid.world_to_grid(bad, 1.0), None);
        assert!(!grid.is_free(1.0, bad) && !grid.is_occupied(bad, bad));
        assert_eq!(
            grid.recenter(Pose2D::new(bad, 0.0, 0.0)),
            Err(Error::NonFinitePose)
        );
        let mut scan =
            |scan: LaserScan<'_>, pose| grid.integrate_scan(&scan, pose, ScanModel::Set, &mut lidar);
        assert_eq!(scan(good, Pose2D::new(1.5, bad, 0.0)), Err(Error::NonFinitePose));
        assert_eq!(
            scan(
                LaserScan {
                    angle_min: bad,
                    ..good
                },
                middle
            ),
            Err(Error::InvalidScan)
        );
        assert_eq!(
            scan(
                LaserScan {
                    angle_increment: bad,
                    ..good
                },
                middle
            ),
            Err(Error::InvalidScan)
        );
        let all_bad = [bad; 4];
        let report = scan(
            LaserScan {
                ranges: &all_bad,
                range_max: f32::INFINITY,
                ..good
            },
            middle,
        )
        .unwrap();
        assert_eq!(
            (report.hits, report.misses, report.ignored, report.changed),
            (0, 0, 4, None)
        );
    }
    let limits = LaserScan {
        range_max: f32::NAN,
        ..good
    };
    assert_eq!(
        grid.integrate_scan(&limits, middle, ScanModel::Set, &mut lidar),
        Err(Error::InvalidScan)
    );
    assert!(grid.data().iter().all(|v| *v == -1));
    assert_eq!(
        grid.recenter(Pose2D::new(3e9, 0.0, 0.0)),
        Err(Error::OffsetOutOfRange)
    );
    assert_eq!(
        grid.recenter(Pose2D::new(0.0, -3e38, 0.0)),
        Err(Error::OffsetOutOfRange)
    );
    assert_eq!(grid.info().offset(), [0, 0]);
}

#[test]
fn scans_that_do_not_fit() {
    let mut cells = [0i8; 100];
    let mut grid = OccupancyGrid::new_in(&mut cells[..], 10, 10, 1.0, Pose2D::default()).unwrap();
    let (mut slots, mut seen) = ([BeamSlot::EMPTY; 4], [0; 3]);
    let mut lidar = ScanWorkspace::new_in(&mut slots, &mut seen);
    let mut run = |ranges: &[f32], model| {
        let scan = LaserScan {
            angle_min: 0.0,
            angle_increment: 0.1,
            range_min: 0.1,
            range_max: 2.0,
            ranges,
        };
        grid.integrate_scan(&scan, Pose2D::new(5.0, 5.0, 0.0), model, &mut lidar)
    };
    let beams = Error::BufferTooSmall {
        buffer: Buffer::Beams,
        needed: 5,
        given: 4,
    };
    assert_eq!(run(&[1.0; 5], ScanModel::Set), Err(beams));
    let seen = Error::BufferTooSmall {
        buffer: Buffer::Seen,
        needed: 4,
        given: 3,
    };
    assert_eq!(run(&[1.0; 4], ScanModel::accumulate()), Err(seen));
    assert_eq!(
        run(&[], ScanModel::Set),
        Ok(ScanReport::default()),
        "an empty scan says nothing"
    );
    let model = ScanModel::Accumulate {
        hit: 10,
        miss: -10,
        min: 60,
        max: 50,
    };
    assert_eq!(run(&[1.0], model), Err(Error::InvalidModel));
}

#[test]
fn parameters_out_of_range_leave_the_old_ones_in_force() {
    let good = CostParams::default();
    let mut wrong = vec![
        (
            CostParams {
                lethal_cost: 1,
                ..good
            },
            Parameter::LethalCost,
        ),
        (
            CostParams {
                lethal_cost: 255,
                ..good
            },
            Parameter::LethalCost,
        ),
        (
            CostParams {
                lethal_threshold: 0,
                ..good
            },
            Parameter::LethalThreshold,
        ),
        (
            CostParams {
                lethal_threshold: 101,
                ..good
            },
            Parameter::LethalThreshold,
        ),
    ];
    for bad in BAD.into_iter().chain([-0.1]) {
        wrong.push((
            CostParams {
                inflation_radius: bad,
                ..good
            },
            Parameter::InflationRadius,
        ));
        wrong.push((
            CostParams {
                cost_scaling_factor: bad,
                ..good
            },
            Parameter::CostScalingFactor,
        ));
        wrong.push((
            CostParams {
                inscribed_radius: bad,
                ..good
            },
            Parameter::InscribedRadius,
        ));
    }
    with_map(Lengths::enough(), good, |map| {
        let mut map = map.unwrap();
        map.set_occupancy(10, 10, 100);
        map.set_occupancy(11, 10, 0);
        map.update_costs();
        for (params, parameter) in wrong {
            assert_eq!(map.set_params(params), Err(Error::InvalidParameter(parameter)));
        }
        let far = CostParams {
            inflation_radius: 0.8,
            cost_scaling_factor: 1.0,
            ..CostParams::nav2()
        };
        assert_eq!(map.set_params(far), Err(Error::RadiusTooLarge { max_cells: 15 }));
        let endless = CostParams {
            inflation_radius: 1e30,
            ..good
        };
        assert_eq!(
            map.set_params(endless),
            Err(Error::RadiusTooLarge { max_cells: 15 })
        );
        assert_eq!((map.params(), map.cost_at(11, 10)), (&good, Some(97)));
        let min = map.min_budget();
        assert_eq!(
            map.update_costs_within(min - 1),
            Err(Error::BudgetTooSmall { min, given: min - 1 })
        );
        assert!(!map.set_occupancy(SIDE, 0, 100) && !map.set_occupancy(0, u32::MAX, 100));
        assert_eq!(
            (map.cost_at(SIDE, 0), map.row(SIDE).len(), map.row(0).len()),
            (None, 0, 20)
        );
    });
}
