//! A wall stays a wall.

use horus_core::evidence::{
    BeamLimits, EvidenceFusion, EvidenceU16, Flatscan, FusionRule, Lattice, MassCell, SensorGrid,
    SensorModel, class_bytes,
};
use horus_core::prelude::Pose2D;

use crate::scene::Scene;

/// A robot looks at a wall one cell thick for 1 000 ticks, drifting and jittering in place and heading.
#[test]
fn a_wall_of_one_cell_stays_sharp_for_a_thousand_ticks() {
    // The wall fills the cells 1.0 m <= x < 1.05 m of the world.
    let window = Lattice::new(80, 80, 0.05, [-0.5, -0.5], "odom").unwrap();
    let lattice = Lattice::new(100, 100, 0.05, [-0.5, -0.5], "robot").unwrap();
    let mut cells = vec![EvidenceU16::VACUOUS; window.cells()];
    let mut map = EvidenceFusion::new_in(&mut cells, window, FusionRule::default()).unwrap();
    let mut bytes = vec![0; class_bytes(100, 100)];
    let model = SensorModel {
        wall_thickness: 0.05,
        ..SensorModel::default()
    };
    let mut sensor = SensorGrid::new_in(&mut bytes, lattice, model).unwrap();
    let mut limits = vec![BeamLimits::EMPTY; 721];
    let angles: Vec<f32> = (0..721).map(|i| -1.2 + i as f32 / 300.0).collect();
    let mut scene = Scene::new(11);
    for tick in 0..1000 {
        let drift = tick as f32 / 1000.0;
        let robot = Pose2D::new(
            0.3 * drift + 0.01 * scene.jitter(),
            0.4 * drift + 0.01 * scene.jitter(),
            0.03 * scene.jitter(),
        );
        let range = |a: &f32| {
            let ahead = libm::cosf(robot.theta + a);
            if ahead > 0.1 {
                (1.0 - robot.x) / ahead
            } else {
                f32::INFINITY
            }
        };
        let ranges: Vec<f32> = angles.iter().map(range).collect();
        let scan = Flatscan {
            angles: &angles,
            ranges: &ranges,
            invalid_range_threshold: 0.05,
            out_of_range_threshold: 3.0,
            visibilities: None,
        };
        map.recenter(robot).unwrap();
        sensor.project(&scan, Pose2D::default(), &mut limits).unwrap();
        map.fuse(&sensor, robot).unwrap();
    }
    // Lines across the wall, in the part that was seen all the time.
    for i in -8..8 {
        let y = 0.4 + 0.05 * i as f32 + 0.025;
        let occupied = |k: i32| map.masses(1.025 + 0.05 * k as f32, y).unwrap().occupied();
        let peak = (-3..=3).map(occupied).fold(0.0, f32::max);
        let wide = (-6..=6).filter(|k| occupied(*k) >= 0.5).count();
        assert!(peak >= 0.9, "y {y}: {peak}");
        assert!(wide <= 2, "y {y}: {wide} cells");
    }
}
