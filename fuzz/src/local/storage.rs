use horus_core::costmap::{CostTables, bit_words, scratch_words};
use horus_core::local::BufferSlot;
use horus_core::prelude::{BeamSlot, Lidar, Pose2D};

use super::LocalCase;
use crate::scene::BEAMS;

/// Names of the lidars.
pub(super) const LIDARS: [&str; 3] = ["front", "", "rear"];

/// Memory that a pair's maps borrow.
pub struct LocalStorage {
    pub(super) size: [u32; 2],
    /// Lidars of others.
    pub(super) external: usize,
    /// Lidars of the map's own.
    pub(super) own: Vec<Lidar<'static>>,
    /// One set of slots per lidar.
    pub(super) beams: Vec<Vec<BeamSlot>>,
    pub(super) slots: Vec<BufferSlot>,
    pub(super) floats: Vec<f32>,
    pub(super) bytes: Vec<u8>,
    pub(super) occupancy: Vec<i8>,
    pub(super) bits: Vec<u32>,
    pub(super) field: Vec<u8>,
    pub(super) scratch: Vec<u32>,
    pub(super) costs: Vec<u8>,
    pub(super) tables: Box<CostTables<u8>>,
}

impl LocalStorage {
    /// Enough for a case.
    pub fn new(case: &LocalCase) -> Self {
        let size = case.size.map(|size| u32::from(size % 41));
        let (external, own) = (usize::from(case.lidars[0] % 3), usize::from(case.lidars[1] % 2));
        let lidar = |&name: &&'static str| Lidar {
            name,
            mount: Pose2D::default(),
            start_angle: 0.0,
            fov: 0.0,
            max_range: 1.0,
        };
        let cells = (size[0] * size[1]) as usize;
        Self {
            size,
            external,
            own: LIDARS[external..external + own].iter().map(lidar).collect(),
            beams: vec![vec![BeamSlot::EMPTY; BEAMS]; LIDARS.len()],
            slots: vec![BufferSlot::EMPTY; 32],
            floats: vec![0.0; 3 * (BEAMS + 6) + 12 + 6],
            bytes: vec![0; cells],
            occupancy: vec![0; cells],
            bits: vec![0; bit_words(size[0], size[1])],
            field: vec![0; cells],
            scratch: vec![0; scratch_words(15)],
            costs: vec![0; cells],
            tables: Box::new(CostTables::EMPTY),
        }
    }
}
