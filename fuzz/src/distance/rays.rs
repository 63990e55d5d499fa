use horus_core::nalgebra::{UnitComplex, Vector2};
use horus_core::prelude::Pose2D;
use horus_core::raycast::{CellWalk, RayCaster, WalkRule};
use horus_host::reference::{
    BelugaGrid, Values, Walk, standard_walk, supercover_walk, walk_cell, walk_steps,
};

use super::case::Scene;
use crate::number::Number;
use crate::scene::{Place, std_pose};

const RULES: [(WalkRule, Walk); 3] = [
    (WalkRule::Standard, Walk::Standard),
    (WalkRule::Supercover, Walk::Supercover),
    (WalkRule::Navground, Walk::Navground),
];

/// A ray by every rule.
pub(super) fn check(scene: &Scene, pose: &Place, bearing: Number, range: Number) {
    let resolution = scene.core.resolution();
    let (at, origin) = (pose.pose(resolution), scene.core.origin());
    let pose = Pose2D::new(at.x + origin.x, at.y + origin.y, at.theta);
    let (bearing, range) = (bearing.of(0.1), range.of(resolution));
    // The std version walks the whole ray.
    let walked = (range / resolution).abs() < 1e4;
    let beluga = BelugaGrid {
        grid: &scene.std,
        values: Values::Horus,
    };
    for (rule, walk) in RULES {
        let rays = RayCaster::new(&scene.core, pose.isometry(), range, rule);
        let bearing_of = UnitComplex::new(bearing);
        let trace: Vec<[i32; 2]> = rays.trace(bearing_of).take(1000).map(Into::into).collect();
        let cast = rays.cast(bearing_of);
        assert!(trace.len() < 1000, "a trace is cut at the map's border");
        if !walked {
            continue;
        }
        assert_eq!(
            trace,
            beluga.trace(std_pose(pose), bearing.into(), range, walk),
            "{rule:?}"
        );
        let expected = beluga.cast(std_pose(pose), bearing.into(), range, walk);
        assert_eq!(cast.is_some(), expected.is_some(), "{rule:?}");
        if let Some((cast, expected)) = cast.zip(expected) {
            let error = (f64::from(cast) - expected).abs();
            assert!(
                error <= 1e-6 * expected.abs() || error < 1e-37,
                "{cast} {expected}"
            );
        }
    }
}

/// A walk by every rule.
pub(super) fn check_walk(from: [i16; 2], to: [i16; 2]) {
    let from = from.map(i32::from);
    let to = [0, 1].map(|axis| from[axis] + i32::from(to[axis] % 300));
    for (rule, _) in RULES {
        let cells: Vec<[i32; 2]> = CellWalk::new(Vector2::from(from), Vector2::from(to), rule)
            .map(Into::into)
            .collect();
        let expected = match rule {
            WalkRule::Standard => standard_walk(from, to),
            WalkRule::Supercover => supercover_walk(from, to),
            WalkRule::Navground => {
                let steps = 0..=walk_steps(from, to);
                steps
                    .map(|step| walk_cell(from, to, step).map(|c| c as i32))
                    .collect()
            }
        };
        assert_eq!(cells, expected, "{rule:?}");
    }
}
