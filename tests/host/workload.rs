//! The meter's workload is of the kind that the targets were set for.

use horus_core::prelude::*;
use horus_tests::workload::{BEAMS, Lidar, Office, RESOLUTION, robot};

fn office() -> Office {
    let mut office = Office::empty();
    office.build();
    office
}

#[test]
fn a_tenth_of_the_office_is_occupied() {
    let share = f64::from(office().obstacles()) / f64::from(Office::SIDE * Office::SIDE);
    assert!((0.09..0.105).contains(&share), "{share}");
}

#[test]
fn the_robot_moves_one_cell_per_tick() {
    for tick in 0..200 {
        let (a, b) = (robot(tick), robot(tick + 1));
        let cells = f64::from((b.x - a.x).hypot(b.y - a.y) / RESOLUTION);
        assert!((0.99..1.01).contains(&cells), "tick {tick}: {cells}");
        let (x, y) = ((a.x / RESOLUTION) as i32, (a.y / RESOLUTION) as i32);
        assert!(!office().is_blocked(x, y), "tick {tick}: in a wall");
    }
}

#[test]
fn a_scan_changes_about_115_cells() {
    let (office, mut lidar) = (office(), Lidar::new());
    let mut cells = vec![0i8; 200 * 200];
    let mut grid = OccupancyGrid::new_in(&mut cells[..], 200, 200, RESOLUTION, Pose2D::default()).unwrap();
    for gy in 0..200 {
        for gx in 0..200 {
            let value = if office.is_blocked(gx as i32, gy as i32) {
                100
            } else {
                0
            };
            grid.set_occupancy(gx, gy, value);
        }
    }
    let mut beams = ScanBuffers::<BEAMS, 0>::empty();
    let mut workspace = beams.workspace();
    let (mut changes, scans) = (0, 40);
    for tick in 0..scans {
        let old = grid.data().to_vec();
        let scan = lidar.measure(&office, tick);
        grid.integrate_scan(&scan, robot(tick), ScanModel::Set, &mut workspace)
            .unwrap();
        if tick > 0 {
            changes += old
                .iter()
                .zip(grid.data())
                .filter(|(old, new)| old != new)
                .count();
        }
    }
    let mean = changes as f64 / f64::from(scans - 1);
    assert!((105.0..125.0).contains(&mean), "{mean}");
}
