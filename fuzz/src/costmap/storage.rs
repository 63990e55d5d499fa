use horus_core::costmap::{CostTables, FieldCell, bit_words, scratch_words};
use horus_core::prelude::CostBuffers;

/// A field cell, with what the targets need to know of it.
pub trait Width: FieldCell {
    /// Most cells of a map, so that the std version takes milliseconds at most.
    const CELLS: u32;
    /// Cells that a full-scale radius means.
    const RADIUS_SCALE: f32;
}

impl Width for u8 {
    const CELLS: u32 = 480;
    const RADIUS_SCALE: f32 = 16.5;
}

impl Width for u16 {
    const CELLS: u32 = 300;
    const RADIUS_SCALE: f32 = 42.0;
}

/// All memory of one core cost map, exactly as long as needed and filled with garbage.
pub struct Storage<F: Width> {
    cells: Vec<i8>,
    field: Vec<F>,
    bits: Vec<u32>,
    scratch: Vec<u32>,
    costs: Option<Vec<u8>>,
    tables: Box<CostTables<F>>,
}

impl<F: Width> Storage<F> {
    /// Memory for a map of this size; `small_scratch` serves radii up to 15 cells only.
    pub fn new((width, height): (u32, u32), keep: bool, small_scratch: bool, garbage: u8) -> Self {
        let cells = width as usize * height as usize;
        let words = u32::from(garbage) * 0x0101_0101;
        let radius = if small_scratch { 15 } else { 31 };
        Self {
            cells: vec![garbage as i8; cells],
            field: vec![F::new(words % 65536); cells],
            bits: vec![words; bit_words(width, height)],
            scratch: vec![words; scratch_words(radius)],
            costs: keep.then(|| vec![garbage; cells]),
            tables: Box::new(CostTables::EMPTY),
        }
    }

    /// The grid's cells and the cost map's buffers.
    pub fn split(&mut self) -> (&mut [i8], CostBuffers<'_, F>) {
        let buffers = CostBuffers {
            bits: &mut self.bits,
            field: &mut self.field,
            scratch: &mut self.scratch,
            costs: self.costs.as_deref_mut(),
            tables: &mut self.tables,
        };
        (&mut self.cells, buffers)
    }
}
