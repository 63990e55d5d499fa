//! Operations both sides know.

use horus_core::grid::ScanModel;
use proptest::prelude::*;

/// One operation on a map.
#[derive(Clone, Debug)]
pub enum Op {
    Set {
        gx: u32,
        gy: u32,
        value: i8,
    },
    Block {
        gx: u32,
        gy: u32,
        size: u32,
        value: i8,
    },
    Scan(Scan),
    /// Moves the robot by so many cells, not only whole ones.
    Move {
        dx: f32,
        dy: f32,
    },
    Jump {
        x: f32,
        y: f32,
    },
    Update,
    /// Budget above the smallest, and how many calls at most.
    UpdateWithin {
        extra: u32,
        calls: u32,
    },
}

/// A scan from somewhere near the map.
#[derive(Clone, Debug)]
pub struct Scan {
    pub x: f32,
    pub y: f32,
    pub theta: f32,
    pub angle_min: f32,
    pub angle_increment: f32,
    pub ranges: Vec<f32>,
    pub model: ScanModel,
}

fn value() -> impl Strategy<Value = i8> {
    prop_oneof![3 => Just(0i8), 3 => Just(100), 2 => Just(-1), 2 => any::<i8>(), 2 => 40..70i8]
}

fn range(reach: f32) -> impl Strategy<Value = f32> {
    prop_oneof![
        12 => 0.0..reach,
        1 => Just(f32::INFINITY),
        1 => Just(f32::NEG_INFINITY),
        1 => Just(f32::NAN),
        1 => Just(-1.0f32),
        1 => Just(3.0f32),
        1 => any::<f32>(),
    ]
}

fn model() -> impl Strategy<Value = ScanModel> {
    prop_oneof![
        Just(ScanModel::Set),
        Just(ScanModel::accumulate()),
        (0..=127i8, -128..=0i8, 0..=100i8, 0..=100i8).prop_map(|(hit, miss, a, b)| ScanModel::Accumulate {
            hit,
            miss,
            min: a.min(b),
            max: a.max(b)
        }),
    ]
}

/// A scan whose sensor lies within a few metres of the world's origin.
pub fn scan() -> impl Strategy<Value = Scan> {
    let pose = (-3.0f32..3.0, -3.0f32..3.0, -7.0f32..7.0);
    let angles = (-4.0f32..4.0, prop_oneof![Just(0.0174f32), -0.4f32..0.4]);
    (pose, angles, prop::collection::vec(range(4.0), 0..80), model()).prop_map(
        |((x, y, theta), (angle_min, angle_increment), ranges, model)| Scan {
            x,
            y,
            theta,
            angle_min,
            angle_increment,
            ranges,
            model,
        },
    )
}

/// Any operation on a map of `w` x `h` cells; cells just outside are asked for, too.
pub fn op(w: u32, h: u32) -> impl Strategy<Value = Op> {
    prop_oneof![
        6 => (0..=w, 0..=h, value()).prop_map(|(gx, gy, value)| Op::Set { gx, gy, value }),
        1 => (0..w, 0..h, 1..12u32, value())
            .prop_map(|(gx, gy, size, value)| Op::Block { gx, gy, size, value }),
        2 => scan().prop_map(Op::Scan),
        2 => (-6.0f32..6.0, -6.0f32..6.0).prop_map(|(dx, dy)| Op::Move { dx, dy }),
        1 => (-40.0f32..40.0, -40.0f32..40.0).prop_map(|(x, y)| Op::Jump { x, y }),
        3 => Just(Op::Update),
        2 => (0..4000u32, 1..6u32).prop_map(|(extra, calls)| Op::UpdateWithin { extra, calls }),
    ]
}
