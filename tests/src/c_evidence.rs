//! The drive of local mapping that `tests/c/evidence.c` repeats through the C interface: the same lines.
//!
//! All input comes from integers and single multiplications, so that both languages feed the same bits; the
//! two texts follow each other.

use horus_core::evidence::{
    BinaryThresholds, EvidenceU16, Flatscan, FusionOperator, FusionRule, Inpaint, InpaintFrame, Lattice,
    LocalMapping, LocalMappingConfig, MappingBuffers, Masses, SensorConfig, SensorModel, SensorScan,
};
use horus_core::prelude::*;

use crate::hash::Hash;
use crate::made_up::metres;
use crate::report::Line;

/// Cells per side of the fused map and of the lidar's lattice.
const SIDE: u32 = 56;
const BEAMS: usize = 120;
const TICKS: i32 = 12;

/// Corner of a lattice around its frame's origin.
fn around(cells: u32, cell: f32) -> f32 {
    cell * -0.5 * cells as f32
}

fn lattice() -> Lattice {
    Lattice {
        rows: SIDE,
        cols: SIDE,
        cell_size: 0.05,
        pose: Pose2D::new(around(SIDE, 0.05), around(SIDE, 0.05), 0.0),
        ..Lattice::default()
    }
}

/// One drive.
///
/// # Errors
/// Buffers that are too short.
pub fn drive(
    name: &'static str,
    operator: FusionOperator,
    buffers: MappingBuffers<'_>,
    mut show: impl FnMut(Line),
) -> Result<(), Error> {
    let sensors = [SensorConfig {
        lattice: lattice(),
        mount: Pose2D::new(metres(100), metres(-50), metres(300)),
        model: SensorModel::default(),
    }];
    let inpaint = [Inpaint {
        frame: InpaintFrame::Robot,
        x: [metres(-200), metres(250)],
        y: [metres(-200), metres(200)],
        masses: Masses::known(1.0, 0.0)?,
    }];
    let config = LocalMappingConfig {
        lattice: lattice(),
        rule: FusionRule::new(operator),
        sensors: &sensors,
        inpaint: &inpaint,
        thresholds: BinaryThresholds::default(),
        max_distance: 2.0,
    };
    let mut mapping = LocalMapping::new_in(buffers, config)?;
    let (mut angles, mut ranges) = ([0.0; BEAMS], [0.0; BEAMS]);
    for (i, angle) in (0..).zip(&mut angles) {
        *angle = metres(52 * i - 3100);
    }
    let mut hash = Hash::default();
    for tick in 0..TICKS {
        for (i, range) in (0..).zip(&mut ranges) {
            *range = match (7 * i + 3 * tick) % 61 {
                0 => f32::NAN,
                1 => f32::INFINITY,
                2 => metres(10),
                _ => metres(700 + (29 * i + 13 * tick) % 900),
            };
        }
        let scan = SensorScan {
            sensor: 0,
            scan: Flatscan {
                angles: &angles,
                ranges: &ranges,
                invalid_range_threshold: metres(50),
                out_of_range_threshold: metres(3000),
                visibilities: None,
            },
        };
        let robot = Pose2D::new(metres(37 * tick), metres(21 * tick), metres(110 * tick));
        let report = mapping.tick(&[scan], robot)?;
        report.shift.into_iter().for_each(|by| hash.word(by as u32));
        hash.word(report.fusion.conflicts);
        hash.word(report.fusion.conflict_mass.to_bits());
        for gy in 0..SIDE {
            for gx in 0..SIDE {
                let cell = mapping.evidence().cell_at(gx, gy).unwrap_or_default();
                hash.word(steps(cell));
                hash.byte(u8::from(mapping.binary().is_occupied(gx, gy) == Some(true)));
                hash.word(mapping.distance().metres_at(gx, gy).unwrap_or(-1.0).to_bits());
                // The lidar's lattice has as many rows and columns.
                hash.byte(mapping.class_at(gx, gy) as u8);
            }
        }
    }
    show(Line {
        scenario: name,
        tick: TICKS as u32 - 1,
        stage: "all",
        hash,
    });
    Ok(())
}

fn steps(cell: EvidenceU16) -> u32 {
    u32::from(cell.free_steps()) << 16 | u32::from(cell.occupied_steps())
}
