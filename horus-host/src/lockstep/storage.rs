use std::mem::{size_of, size_of_val};

use horus_core::costmap::{CostTables, bit_words, scratch_words};
use horus_core::local::BufferSlot;
use horus_core::prelude::{BeamSlot, CostMap, LocalGridMap, ScanModel, ScanWorkspace, SensingState};
use horus_core::storage::bitmap_words;

use super::{FieldWidth, LockstepConfig, LockstepError, RamUse};

/// All memory of the core side, allocated once and borrowed by [`Lockstep`](super::Lockstep).
#[derive(Debug)]
pub struct CoreStorage {
    pub(super) cells: Vec<i8>,
    pub(super) bits: Vec<u32>,
    pub(super) scratch: Vec<u32>,
    pub(super) costs: Option<Vec<u8>>,
    pub(super) beams: Vec<BeamSlot>,
    pub(super) seen: Vec<u32>,
    pub(super) field: FieldStorage,
    pub(super) local: Option<LocalStorage>,
    radius: u32,
}

/// A local map and its sensing state.
#[derive(Debug)]
pub(super) struct LocalStorage {
    pub cells: Vec<u8>,
    pub slots: Vec<BufferSlot>,
    pub floats: Vec<f32>,
}

impl LocalStorage {
    /// Buffers of a lidar and of an odometry sensor.
    const SLOTS: usize = 7;
    /// Numbers in them besides the ranges.
    const FLOATS: usize = 12;

    fn bytes(&self) -> usize {
        let handles = size_of::<LocalGridMap<'_, &mut [u8]>>() + size_of::<SensingState<'_>>();
        handles + self.cells.len() + size_of_val(&self.slots[..]) + size_of_val(&self.floats[..])
    }
}

/// Distance field and tables, of the type the parameters need.
#[derive(Debug)]
pub(super) enum FieldStorage {
    One(Vec<u8>, Box<CostTables<u8>>),
    Two(Vec<u16>, Box<CostTables<u16>>),
}

impl CoreStorage {
    /// Memory for a map and scans of up to `beams` beams.
    ///
    /// # Errors
    /// Whatever is wrong with the configuration; [`LockstepError::Memory`].
    pub fn new(config: &LockstepConfig, beams: usize) -> Result<Self, LockstepError> {
        config.validate()?;
        let (width, radius) = FieldWidth::of(config)?;
        let cells = config.cells();
        let seen = match config.model {
            ScanModel::Set => 0,
            ScanModel::Accumulate { .. } => bitmap_words(config.width, config.height),
        };
        let field = match width {
            FieldWidth::One => FieldStorage::One(filled(0, cells, config)?, Box::new(CostTables::EMPTY)),
            FieldWidth::Two => FieldStorage::Two(filled(0, cells, config)?, Box::new(CostTables::EMPTY)),
        };
        Ok(Self {
            cells: filled(0, cells, config)?,
            bits: filled(0, bit_words(config.width, config.height), config)?,
            scratch: filled(0, scratch_words(radius), config)?,
            costs: config.keep_costs.then(|| filled(0, cells, config)).transpose()?,
            beams: filled(BeamSlot::EMPTY, beams, config)?,
            seen: filled(0, seen, config)?,
            field,
            local: match config.local {
                None => None,
                Some(_) => Some(LocalStorage {
                    cells: filled(0, cells, config)?,
                    slots: vec![BufferSlot::EMPTY; LocalStorage::SLOTS],
                    floats: filled(0.0, beams.saturating_add(LocalStorage::FLOATS), config)?,
                }),
            },
            radius,
        })
    }

    /// The type of the distance field's cells.
    pub fn field_width(&self) -> FieldWidth {
        match self.field {
            FieldStorage::One(..) => FieldWidth::One,
            FieldStorage::Two(..) => FieldWidth::Two,
        }
    }

    /// How many cells the costs above zero reach.
    pub fn effective_radius(&self) -> u32 {
        self.radius
    }

    /// The memory in bytes, with that of the handles that will borrow it.
    pub fn ram_use(&self) -> RamUse {
        let (field, tables, map) = match &self.field {
            FieldStorage::One(field, _) => (
                size_of_val(&field[..]),
                size_of::<CostTables<u8>>(),
                size_of::<CostMap<'_, u8>>(),
            ),
            FieldStorage::Two(field, _) => (
                size_of_val(&field[..]),
                size_of::<CostTables<u16>>(),
                size_of::<CostMap<'_, u16>>(),
            ),
        };
        RamUse {
            cells: size_of_val(&self.cells[..]),
            field,
            bits: size_of_val(&self.bits[..]),
            costs: self.costs.as_ref().map_or(0, Vec::len),
            scratch: size_of_val(&self.scratch[..]),
            tables,
            beams: size_of_val(&self.beams[..]),
            seen: size_of_val(&self.seen[..]),
            local: self.local.as_ref().map_or(0, LocalStorage::bytes),
            handles: map + size_of::<ScanWorkspace<'_>>(),
        }
    }
}

/// A vector of `len` equal elements, or an error instead of an abort.
fn filled<T: Clone>(value: T, len: usize, config: &LockstepConfig) -> Result<Vec<T>, LockstepError> {
    let mut elements = Vec::new();
    elements.try_reserve_exact(len).or(Err(LockstepError::Memory {
        width: config.width,
        height: config.height,
    }))?;
    elements.resize(len, value);
    Ok(elements)
}
