use horus_core::prelude::{CostParams, LaserScan, Pose2D, ScanModel};

use super::comparison::compare;
use super::{CoreStorage, FieldWidth, Layer, Layers, Lockstep, LockstepConfig, LockstepError};

fn small() -> LockstepConfig {
    LockstepConfig {
        width: 33,
        height: 20,
        ..LockstepConfig::default()
    }
}

fn ranges(seed: u32) -> Vec<f32> {
    let range = |i: u32| match (i * 7 + seed) % 11 {
        0 => f32::INFINITY,
        1 => f32::NAN,
        2 => f32::NEG_INFINITY,
        n => 0.08 * n as f32,
    };
    (0..90).map(range).collect()
}

fn scan(ranges: &[f32]) -> LaserScan<'_> {
    LaserScan {
        angle_min: -3.0,
        angle_increment: 0.07,
        range_min: 0.05,
        range_max: 1.5,
        ranges,
    }
}

#[test]
fn every_combination_of_field_model_and_storage_agrees() {
    let wide = CostParams {
        cost_scaling_factor: 1.0,
        ..CostParams::default().with_radius(1.0)
    };
    for (params, field) in [
        (CostParams::default(), FieldWidth::One),
        (CostParams::horus(), FieldWidth::One),
        (CostParams::nav2(), FieldWidth::One),
        (wide, FieldWidth::Two),
    ] {
        for model in [ScanModel::Set, ScanModel::accumulate()] {
            for keep_costs in [false, true] {
                let config = LockstepConfig {
                    params,
                    model,
                    keep_costs,
                    ..small()
                };
                let mut storage = CoreStorage::new(&config, 90).unwrap();
                assert_eq!(storage.field_width(), field);
                let mut lockstep = Lockstep::new(&config, &mut storage).unwrap();
                for tick in 0..30 {
                    let at = tick as f32 * 0.11;
                    let (robot, sensor) = (Pose2D::new(at, -at, at), Pose2D::new(at + 0.1, -at, at));
                    let ranges = ranges(tick);
                    assert_eq!(lockstep.tick(tick.into(), &scan(&ranges), robot, sensor), None);
                }
                assert_eq!(lockstep.first_mismatch(), None);
                assert_eq!(lockstep.totals().mismatches, 0);
                assert_eq!(lockstep.totals().cells_compared, 30 * 2 * 33 * 20);
                let seen = lockstep.core_layers();
                assert!(seen.occupancy.contains(&100) && seen.costs.contains(&params.lethal_cost));
                assert_ne!(seen.offset, [0, 0], "the window has moved");
            }
        }
    }
}

#[test]
fn a_refused_tick_changes_nothing_and_says_why() {
    let mut storage = CoreStorage::new(&small(), 90).unwrap();
    let mut lockstep = Lockstep::new(&small(), &mut storage).unwrap();
    let ranges = ranges(3);
    let here = Pose2D::default();
    assert_eq!(lockstep.tick(0, &scan(&ranges), here, here), None);
    let before = lockstep.core_layers().clone();
    let nowhere = Pose2D::new(f32::NAN, 0.0, 0.0);
    let broken = LaserScan {
        range_max: f32::NAN,
        ..scan(&ranges)
    };
    let reason = lockstep.tick(1, &broken, nowhere, here);
    assert_eq!(reason.as_deref(), Some("a pose coordinate is NaN or infinite"));
    assert_eq!(*lockstep.core_layers(), before);
    assert_eq!(lockstep.totals().mismatches, 0);
}

#[test]
fn a_refusal_of_one_side_is_a_mismatch() {
    // Room for fewer beams than the scan has: only the core has a limit.
    let mut storage = CoreStorage::new(&small(), 10).unwrap();
    let mut lockstep = Lockstep::new(&small(), &mut storage).unwrap();
    let ranges = ranges(0);
    assert_eq!(
        lockstep.tick(0, &scan(&ranges), Pose2D::default(), Pose2D::default()),
        None
    );
    let first = lockstep.first_mismatch().unwrap();
    assert_eq!((first.layer, first.cell), (Layer::Refusal, None));
    assert!(first.core.contains("90 are needed"), "{first}");
    assert!(lockstep.totals().mismatches > 1, "the maps differ too");
}

#[test]
fn the_first_differing_cell_is_shown_from_both_sides() {
    let core = Layers {
        offset: [0; 2],
        occupancy: vec![0; 12],
        costs: vec![0; 12],
    };
    let mut std = core.clone();
    assert!(compare(&core, &std, 4, 253, (0, 0)).first.is_none());
    std.costs[6] = 97;
    std.costs[11] = 253;
    let comparison = compare(&core, &std, 4, 253, (8, 9));
    assert_eq!(comparison.differing, 2);
    let text = comparison.first.unwrap().to_string();
    let expected = "first mismatch: cost of cell (2, 1) in tick 8 at 9 ns: core 0, std 97\n\
                    core:\n2  . . . .\n1  . .[.].\n0  . . . .\ngx 0..=3\n\
                    std:\n2  . . . #\n1  . .[3].\n0  . . . .\ngx 0..=3\n\
                    different (x):\n2  . . . x\n1  . .[x].\n0  . . . .\ngx 0..=3";
    assert_eq!(text, expected);
    std.occupancy[0] = 100;
    let first = compare(&core, &std, 4, 253, (8, 9)).first.unwrap();
    assert_eq!((first.layer, first.cell), (Layer::Occupancy, Some((0, 0))));
}

#[test]
fn bad_configurations_are_refused_in_words() {
    let error = |config: LockstepConfig| CoreStorage::new(&config, 1).unwrap_err().to_string();
    let most = LockstepConfig::MOST_CELLS;
    assert_eq!(
        error(LockstepConfig { width: 0, ..small() }),
        format!("a map of 0 x 20 cells is not possible: it needs 1 to {most} cells")
    );
    assert!(
        error(LockstepConfig {
            width: u32::MAX,
            height: u32::MAX,
            ..small()
        })
        .contains("4294967295")
    );
    assert_eq!(
        error(LockstepConfig {
            resolution: f32::NAN,
            ..small()
        }),
        "resolution NaN m is not finite and above zero"
    );
    let params = CostParams::nav2().with_radius(100.0);
    let radius = LockstepConfig {
        params: CostParams {
            cost_scaling_factor: 0.0,
            ..params
        },
        ..small()
    };
    assert_eq!(
        CoreStorage::new(&radius, 1).unwrap_err(),
        LockstepError::Radius {
            radius: 100.0,
            resolution: 0.05,
            max_cells: 255
        }
    );
    let params = CostParams {
        lethal_cost: 1,
        ..CostParams::default()
    };
    assert!(error(LockstepConfig { params, ..small() }).contains("lethal_cost"));
}

#[test]
fn memory_of_the_core_stays_within_its_promise() {
    for (keep_costs, radius, k, most) in [
        (false, 0.55, 10.0, 2.5),
        (true, 0.55, 10.0, 3.5),
        (false, 1.0, 1.0, 3.5),
    ] {
        let params = CostParams {
            cost_scaling_factor: k,
            ..CostParams::default().with_radius(radius)
        };
        let config = LockstepConfig {
            width: 400,
            height: 400,
            params,
            keep_costs,
            ..small()
        };
        let ram = CoreStorage::new(&config, 360).unwrap().ram_use();
        assert_eq!(ram.cells, 160_000);
        let per_cell = (ram.cells + ram.field + ram.bits + ram.costs) as f64 / ram.cells as f64;
        assert!(per_cell <= most, "{per_cell} bytes per cell");
        assert!(ram.per_cell() < most + 0.2, "{}", ram.per_cell());
    }
}
