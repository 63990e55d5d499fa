//! Local mapping with evidence grids: 128 x 128 cells of 16-bit masses, 360 beams, fused by PCR6.
#![no_std]
#![no_main]

use horus_core::evidence::*;
use horus_core::prelude::*;
use horus_core::storage::bitmap_words;
use horus_footprint::{in_bss, need, opaque};

horus_footprint::start!(run);

const SIDE: u32 = 128;
const CELLS: usize = (SIDE * SIDE) as usize;

type Buffers = LocalMappingBuffers<
    CELLS,
    { class_bytes(SIDE, SIDE) },
    { bitmap_words(SIDE, SIDE) },
    360,
    { SIDE as usize },
>;

fn run() {
    need(drive());
}

fn drive() -> Result<(), Error> {
    let lidar = SensorConfig {
        lattice: Lattice::new(SIDE, SIDE, 0.05, [-0.5, -0.5], "robot")?,
        mount: opaque(Pose2D::new(0.1, 0.0, 0.0)),
        model: SensorModel::default(),
    };
    let config = LocalMappingConfig {
        lattice: Lattice::new(SIDE, SIDE, 0.05, [-0.5, -0.5], "odom")?,
        rule: FusionRule::new(FusionOperator::Pcr6),
        sensors: &[lidar],
        inpaint: &[],
        thresholds: BinaryThresholds::default(),
        max_distance: 2.0,
    };
    let mut mapping = LocalMapping::new_in(in_bss!(Buffers, Buffers::empty()).split(), config)?;
    let angles = &*opaque(in_bss!([f32; 360], [0.0; 360]));
    let ranges = &*opaque(in_bss!([f32; 360], [0.0; 360]));
    loop {
        let scan = Flatscan {
            angles,
            ranges,
            invalid_range_threshold: 0.05,
            out_of_range_threshold: 8.0,
            visibilities: None,
        };
        need(mapping.tick(&[SensorScan { sensor: 0, scan }], opaque(Pose2D::default()))?);
        need(mapping.evidence().masses_at(opaque(1), opaque(2)));
        need(mapping.binary().is_occupied(opaque(1), opaque(2)));
        need(mapping.distance().metres_at(opaque(1), opaque(2)));
    }
}
