//! Sequences of changes, shifts, scans and updates.

use horus_core::costmap::FieldCell;
use horus_core::prelude::*;
use proptest::prelude::*;

use crate::op::{Op, op};
use crate::pair::{Buffers, Pair, Setup};

fn params(max_cells: u32, resolution: f32) -> impl Strategy<Value = CostParams> {
    let radius = prop_oneof![
        (0..=max_cells).prop_map(move |n| n as f32 * resolution),
        (0.0..max_cells as f32).prop_map(move |n| n * resolution),
    ];
    let factor = prop_oneof![Just(0.0f32), Just(1.0), Just(10.0), 0.0f32..20.0];
    let lethal = prop_oneof![Just(253u8), Just(254), 2..=254u8];
    let threshold = prop_oneof![Just(50i8), Just(65), Just(100), 1..=100i8];
    let exponential = any::<bool>();
    let flags = any::<(bool, bool)>();
    let inscribed = 0.0..3.0 * resolution;
    (radius, factor, lethal, threshold, exponential, flags, inscribed).prop_map(
        |(
            inflation_radius,
            cost_scaling_factor,
            lethal_cost,
            lethal_threshold,
            exponential,
            flags,
            inscribed_radius,
        )| {
            CostParams {
                inflation_radius,
                cost_scaling_factor,
                lethal_cost,
                lethal_threshold,
                unknown_inflates: flags.0,
                decay: if exponential {
                    Decay::Exponential
                } else {
                    Decay::Polynomial
                },
                inscribed_radius,
                inflate_unknown: flags.1,
            }
        },
    )
}

fn preset(max_cells: u32, resolution: f32) -> impl Strategy<Value = CostParams> {
    prop_oneof![
        3 => params(max_cells, resolution),
        1 => Just(CostParams::default()),
        1 => Just(CostParams::horus()),
        1 => Just(CostParams::nav2()),
    ]
}

fn size() -> impl Strategy<Value = (u32, u32)> {
    prop_oneof![
        1 => Just((1, 1)),
        1 => (1..80u32).prop_map(|n| (1, n)),
        1 => (1..80u32).prop_map(|n| (n, 1)),
        3 => (1..50u32, 1..50u32),
        1 => Just((31, 33)),
        1 => Just((64, 64)),
    ]
}

fn setup(max_cells: u32) -> impl Strategy<Value = Setup> {
    let resolution = prop_oneof![Just(0.05f32), Just(0.1), 0.02f32..0.3];
    let origin = (
        -2.0f32..2.0,
        -2.0f32..2.0,
        prop_oneof![Just(0.0f32), -4.0f32..4.0],
    );
    (size(), resolution, origin).prop_flat_map(move |((width, height), resolution, (x, y, theta))| {
        preset(max_cells, resolution).prop_map(move |params| Setup {
            width,
            height,
            resolution,
            origin: Pose2D::new(x, y, theta),
            params,
        })
    })
}

fn case(max_cells: u32) -> impl Strategy<Value = (Setup, Vec<Op>, bool)> {
    setup(max_cells).prop_flat_map(|setup| {
        let ops = prop::collection::vec(op(setup.width, setup.height), 1..40);
        (Just(setup), ops, any::<bool>())
    })
}

/// Whether every cost is exact now, and what is known of the changes since the last time.
struct Since {
    costs: Vec<u8>,
    shifted: bool,
    changed: Option<CellRect>,
}

fn run<F: FieldCell>(setup: &Setup, ops: &[Op], kept: bool) {
    let mut buffers = Buffers::<F>::new(setup.width, setup.height, kept);
    let Some(mut pair) = Pair::new(&mut buffers, setup) else {
        return;
    };
    pair.check_costs();
    let mut since = Since {
        costs: pair.costs(),
        shifted: false,
        changed: None,
    };
    for op in ops {
        match *op {
            Op::Set { gx, gy, value } => pair.set(gx, gy, value),
            Op::Block { gx, gy, size, value } => {
                for y in gy..(gy + size).min(setup.height) {
                    (gx..(gx + size).min(setup.width)).for_each(|x| pair.set(x, y, value));
                }
            }
            Op::Scan(ref scan) => pair.scan(scan),
            Op::Move { dx, dy } => since.shifted |= pair.move_by(dx, dy),
            Op::Jump { x, y } => since.shifted |= pair.recenter(x, y),
            Op::Update => {
                let changed = pair.core.update_costs();
                finished(&mut pair, &mut since, changed, kept);
            }
            Op::UpdateWithin { extra, calls } => {
                let budget = pair.core.min_budget() + extra;
                let promised = pair.core.calls_left();
                for call in 1..=calls {
                    let update = pair.core.update_costs_within(budget).unwrap();
                    if update.pending == 0 {
                        assert!(call <= promised.max(1), "call {call} of {promised}");
                        finished(&mut pair, &mut since, update.changed, kept);
                        break;
                    }
                    since.changed = union(since.changed, update.changed);
                }
            }
        }
        pair.check_cells();
    }
    // However much was pending: the stated number of smallest budgets finishes it (a shift that
    // left nothing to do is still to be reported).
    let promised = pair.core.calls_left();
    let budget = pair.core.min_budget();
    for _ in 0..promised.max(1) {
        pair.core.update_costs_within(budget).unwrap();
    }
    assert_eq!(pair.core.calls_left(), 0);
    pair.check_costs();
    assert_eq!(pair.core.update_costs(), None, "nothing is left to do");
}

fn union(a: Option<CellRect>, b: Option<CellRect>) -> Option<CellRect> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.union(&b)),
        (a, b) => a.or(b),
    }
}

/// Checks costs and the rectangle of changes after an update that finished everything.
fn finished<F: FieldCell>(pair: &mut Pair<'_, F>, since: &mut Since, changed: Option<CellRect>, kept: bool) {
    pair.check_costs();
    let now = pair.costs();
    let width = setup_width(pair);
    let one_call = since.changed.is_none();
    let changed = union(since.changed, changed);
    let mut smallest = None;
    for (i, _) in now
        .iter()
        .zip(&since.costs)
        .enumerate()
        .filter(|(_, (a, b))| a != b)
    {
        let (gx, gy) = (i as u32 % width, i as u32 / width);
        smallest = union(
            smallest,
            Some(CellRect {
                x0: gx,
                y0: gy,
                x1: gx + 1,
                y1: gy + 1,
            }),
        );
    }
    if since.shifted {
        let whole = CellRect {
            x0: 0,
            y0: 0,
            x1: width,
            y1: pair.core.info().height(),
        };
        assert_eq!(changed, Some(whole), "after a shift: the whole map");
    } else if kept && one_call {
        assert_eq!(changed, smallest, "the smallest rectangle");
    } else {
        assert_eq!(
            union(changed, smallest),
            changed,
            "a rectangle that holds every change"
        );
    }
    *since = Since {
        costs: now,
        shifted: false,
        changed: None,
    };
}

fn setup_width<F: FieldCell>(pair: &Pair<'_, F>) -> u32 {
    pair.core.info().width()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn one_byte_field((setup, ops, kept) in case(15)) {
        run::<u8>(&setup, &ops, kept);
    }

    #[test]
    fn two_byte_field((setup, ops, kept) in case(33)) {
        run::<u16>(&setup, &ops, kept);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, ..ProptestConfig::default() })]

    #[test]
    fn a_large_map(ops in prop::collection::vec(op(200, 200), 1..25), kept: bool, params in preset(15, 0.05)) {
        let origin = Pose2D::new(-5.0, -5.0, 0.0);
        let setup = Setup { width: 200, height: 200, resolution: 0.05, origin, params };
        run::<u8>(&setup, &ops, kept);
    }

    #[test]
    fn a_far_radius(ops in prop::collection::vec(op(90, 70), 1..15), kept: bool, cells in 32..90u32) {
        let params = CostParams {
            inflation_radius: cells as f32 * 0.05,
            cost_scaling_factor: 0.3,
            ..CostParams::default()
        };
        let setup = Setup { width: 90, height: 70, resolution: 0.05, origin: Pose2D::default(), params };
        run::<u16>(&setup, &ops, kept);
    }
}

#[test]
fn an_empty_map_does_nothing() {
    for (width, height) in [(0, 0), (0, 5), (5, 0)] {
        let setup = Setup {
            width,
            height,
            resolution: 0.1,
            origin: Pose2D::default(),
            params: CostParams::default(),
        };
        let mut buffers = Buffers::<u8>::new(width, height, true);
        let mut pair = Pair::new(&mut buffers, &setup).unwrap();
        pair.set(0, 0, 100);
        pair.recenter(3.0, 4.0);
        assert_eq!(pair.core.cost(0.0, 0.0), None);
        assert_eq!(
            pair.core
                .update_costs_within(pair.core.min_budget())
                .unwrap()
                .pending,
            0
        );
        pair.check_costs();
    }
}
