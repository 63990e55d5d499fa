//! Painted rectangles: the binary map, which looks only near a rectangle, has every cell that it holds.

use horus_core::distance::{DistanceBuffers, EnvelopeVertex};
use horus_core::evidence::{
    BeamLimits, BinaryThresholds, EvidenceU16, FusionOperator, FusionRule, Inpaint, InpaintFrame, Lattice,
    LocalMapping, LocalMappingConfig, MappingBuffers, MassCell, Masses,
};
use horus_core::prelude::Pose2D;
use horus_core::storage::bitmap_words;

const SIDE: u32 = 64;

/// Cells painted by a square around the robot, which stands at the middle of the map.
fn painted(robot: Pose2D, cell_size: f32, half: f32) -> u32 {
    let corner = 0.5 * SIDE as f32 * cell_size;
    let square = Inpaint {
        frame: InpaintFrame::Robot,
        x: [-half, half],
        y: [-half, half],
        masses: Masses::known(1.0, 0.0).unwrap(),
    };
    let config = LocalMappingConfig {
        lattice: Lattice {
            rows: SIDE,
            cols: SIDE,
            cell_size,
            pose: Pose2D::new(robot.x - corner, robot.y - corner, 0.0),
            ..Lattice::default()
        },
        rule: FusionRule::new(FusionOperator::Pcr6),
        sensors: &[],
        inpaint: &[square],
        thresholds: BinaryThresholds::default(),
        max_distance: 1.0,
    };
    let cells = (SIDE * SIDE) as usize;
    let buffers = MappingBuffers {
        cells: &mut vec![EvidenceU16::VACUOUS; cells],
        classes: &mut [],
        limits: &mut [BeamLimits::EMPTY; 0],
        binary: &mut vec![0; bitmap_words(SIDE, SIDE)],
        distance: DistanceBuffers {
            cells: &mut vec![0u16; cells][..],
            vertices: &mut vec![EnvelopeVertex::EMPTY; SIDE as usize][..],
        },
    };
    let mut mapping = LocalMapping::new_in(buffers, config).unwrap();
    mapping.tick(&[], robot).unwrap();
    let mut count = 0;
    for (gx, gy) in (0..SIDE).flat_map(|gx| (0..SIDE).map(move |gy| (gx, gy))) {
        let free = mapping.inpainted_at(gx, gy).unwrap().free() > 0.5;
        assert_eq!(
            mapping.binary().is_occupied(gx, gy),
            Some(!free),
            "{robot:?}: ({gx}, {gy})"
        );
        count += u32::from(free);
    }
    count
}

#[test]
fn no_cell_is_missed_far_from_the_origin() {
    assert_eq!(painted(Pose2D::default(), 0.05, 0.2), 64);
    for (x, y) in [
        (500_000.0, 5_400_000.0),
        (606_499.2, 10_143.275),
        (-2e6, 3e6),
        (1e3, -1e3),
        (4e6, 0.0),
    ] {
        for theta in [0.0, 0.7, 2.3] {
            for cell_size in [0.02, 0.05, 0.1] {
                for half in [0.08, 0.2, 0.5] {
                    painted(Pose2D::new(x, y, theta), cell_size, half);
                }
            }
        }
    }
}
