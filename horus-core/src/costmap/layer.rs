//! The state of inflation over somebody's cells, and how it follows their changes.

use super::CellValue;
use super::CostParams;
use super::budget::Budget;
use super::buffers::CostBuffers;
use super::changes::Changes;
use super::edges::Edges;
use super::field::FieldCell;
use super::kernel::{self, scratch_words, with_kernel};
use super::refresh::Refresh;
use super::repair::{Repair, Scope};
use super::steps::Steps;
use super::tables::CostTables;
use super::work::Work;
use crate::error::{Buffer, Error, require};
use crate::geometry::{Bounds, CellRect};
use crate::storage::{Bitmap, bitmap_words, words_per_row};

/// Inflation over cells that somebody else keeps.
///
/// Invariant once the edge strips are done: `field` is the squared distance to the nearest set
/// bit of `sources`, capped at the disc. An update first makes `sources` follow the cells (bit
/// after bit, the invariant holding after each), guided by `changes`.
#[derive(Debug)]
pub(crate) struct Layer<'a, F: FieldCell> {
    pub(super) width: u32,
    pub(super) height: u32,
    /// The sources that `field` reflects; it may lag behind the cells.
    pub(super) sources: &'a mut [u32],
    pub(super) changes: Changes<'a>,
    pub(super) field: &'a mut [F],
    /// First row and end of the stale cells in every strip of 32 columns.
    pub(super) stale_rows: &'a mut [[u32; 2]],
    pub(super) scratch: &'a mut [u32],
    pub(super) costs: Option<&'a mut [u8]>,
    pub(super) tables: &'a mut CostTables<F>,
    pub(super) params: CostParams,
    resolution: f32,
    pub(super) edges: Edges,
    pub(super) cursors: Cursors,
    /// The window has moved since the last update.
    pub(super) moved: bool,
}

/// The first word of changes that each pass of an update has not finished.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Cursors {
    pub insert: usize,
    pub remove: usize,
    pub costs: usize,
}

/// What the field is computed from, and where.
pub(super) struct Parts<'b, F> {
    pub sources: Bitmap<'b>,
    pub field: &'b mut [F],
    pub scratch: &'b mut [u32],
}

impl Cursors {
    /// Nothing has changed: every pass starts at the first word to come.
    pub(super) const END: Self = Self {
        insert: usize::MAX,
        remove: usize::MAX,
        costs: usize::MAX,
    };

    /// The word has a new change.
    #[inline]
    fn back_to(&mut self, word: usize) {
        self.insert = self.insert.min(word);
        self.remove = self.remove.min(word);
        self.costs = self.costs.min(word);
    }
}

impl<'a, F: FieldCell> Layer<'a, F> {
    /// A layer for a grid of this size; not readable before [`compute`](Self::compute).
    pub(crate) fn new(
        width: u32,
        height: u32,
        resolution: f32,
        buffers: CostBuffers<'a, F>,
        params: CostParams,
    ) -> Result<Self, Error> {
        let CostBuffers {
            bits,
            field,
            scratch,
            costs,
            tables,
        } = buffers;
        let cells = width as usize * height as usize;
        let words = bitmap_words(width, height);
        require(Buffer::Bits, super::bit_words(width, height), bits.len())?;
        require(Buffer::Field, cells, field.len())?;
        if let Some(costs) = &costs {
            require(Buffer::Costs, cells, costs.len())?;
        }
        let split = |bits: &'a mut [u32], at| bits.split_at_mut_checked(at).unwrap_or_default();
        let (sources, bits) = split(bits, words);
        let (changes, bits) = split(bits, words);
        let (summary, bits) = split(bits, words.div_ceil(32));
        let (stale_rows, _) = bits.as_chunks_mut();
        let stale_rows = stale_rows.get_mut(..words_per_row(width)).unwrap_or_default();
        stale_rows.fill([0; 2]);
        let mut layer = Self {
            width,
            height,
            sources,
            changes: Changes::new(changes, summary, width, height),
            field: field.get_mut(..cells).unwrap_or_default(),
            stale_rows,
            scratch,
            costs: costs.map(|costs| costs.get_mut(..cells).unwrap_or_default()),
            tables,
            params,
            resolution,
            edges: Edges::default(),
            cursors: Cursors::default(),
            moved: false,
        };
        layer.set_params(params)?;
        Ok(layer)
    }

    /// Takes new parameters; [`compute`](Self::compute) must follow. On an error nothing changes.
    pub(crate) fn set_params(&mut self, params: CostParams) -> Result<(), Error> {
        params.validate()?;
        let disc = CostTables::<F>::reach(&params, self.resolution)?;
        require(Buffer::Scratch, scratch_words(disc.radius), self.scratch.len())?;
        self.tables.fill(&params, self.resolution, disc);
        self.params = params;
        Ok(())
    }

    pub(crate) fn steps(&self) -> Steps {
        Steps::new(self.tables.disc)
    }

    /// A cell of the grid has a new value.
    pub(crate) fn mark(&mut self, gx: u32, gy: u32) {
        let word = self.changes.mark(gx, gy);
        self.cursors.back_to(word);
    }

    /// Forgets what happened and computes everything from the cells.
    pub(crate) fn compute<V: CellValue>(&mut self, values: &[V]) {
        self.changes.clear();
        self.edges.clear();
        self.moved = false;
        self.read_sources(values);
        self.compute_field();
        if let Some(costs) = &mut self.costs {
            for ((cost, value), field) in costs.iter_mut().zip(values).zip(self.field.iter()) {
                self.tables.refresh(cost, *value, *field);
            }
        }
    }

    /// Makes the source bits those of the cells' values.
    pub(super) fn read_sources<V: CellValue>(&mut self, values: &[V]) {
        let per_row = words_per_row(self.width);
        if per_row == 0 {
            return;
        }
        // Zipping the two would divide by the row lengths, which the compiler need not know to be more
        // than 0.
        let mut rows = values.chunks_exact(self.width as usize);
        for words in self.sources.chunks_exact_mut(per_row) {
            let values = rows.next().unwrap_or_default();
            for (word, values) in words.iter_mut().zip(values.chunks(32)) {
                *word = self.tables.source_bits(values);
            }
        }
    }

    /// Computes the whole field from the source bits.
    pub(super) fn compute_field(&mut self) {
        if self.width > 0 {
            let sources = Bitmap::new(self.sources, self.width, self.height);
            kernel::compute(&self.tables.disc, self.scratch, sources, self.field);
        }
    }

    /// Recomputes the cells of a region of at most 32 columns that need it.
    pub(super) fn repair<V: CellValue>(
        &mut self,
        rect: CellRect,
        scope: Scope,
        values: &[V],
        changed: &mut Bounds,
    ) {
        let (parts, mut refresh) = self.refresh(values, changed);
        let tables = refresh.tables;
        let repair = Repair {
            sources: parts.sources,
            field: parts.field,
            rect,
            scope,
            refresh: &mut refresh,
        };
        with_kernel(&tables.disc, parts.scratch, repair);
    }

    /// What writing the field takes, and what must be told of it.
    pub(super) fn refresh<'b, V>(
        &'b mut self,
        values: &'b [V],
        changed: &'b mut Bounds,
    ) -> (Parts<'b, F>, Refresh<'b, V, F>) {
        let parts = Parts {
            sources: Bitmap::new(self.sources, self.width, self.height),
            field: self.field,
            scratch: self.scratch,
        };
        let refresh = Refresh {
            values,
            tables: self.tables,
            costs: self.costs.as_deref_mut(),
            changes: &self.changes,
            changed,
            width: self.width,
        };
        (parts, refresh)
    }

    /// The cost of a cell from its present value and the field.
    #[inline]
    pub(crate) fn cost(&self, i: usize, value: u8) -> Option<u8> {
        self.field.get(i).map(|field| self.tables.cost(value, *field))
    }

    /// Changed cells and edge blocks that wait; 0: everything is exact.
    pub(crate) fn pending(&self) -> u32 {
        self.changes.count().saturating_add(self.blocks_left())
    }

    /// Upper bound on the budgeted updates that finish everything: each does at least one step.
    pub(crate) fn calls_left(&self) -> u32 {
        if self.pending() == 0 {
            return 0;
        }
        // A changed cell is inserted or removed, and its word is looked at in three passes; every
        // pass also ends with a search over the summary words.
        let search = self.sources.len().div_ceil(32) as u32 / self.steps().largest().max(1) + 1;
        self.changes
            .count()
            .saturating_mul(4)
            .saturating_add(self.blocks_left() + 3 * search)
    }

    /// Runs an update; `None`: no cost changed.
    pub(crate) fn update<V: CellValue>(&mut self, values: &[V], budget: &mut Budget) -> Option<CellRect> {
        let mut changed = Bounds::EMPTY;
        let mut work = Work::new(self.field.len(), self.tables.disc.side().pow(2), budget);
        let _finished = self.insert(values, budget, &mut work, &mut changed)
            && self.repair_edges(values, budget, &mut changed)
            && self.remove(values, budget, &mut work, &mut changed)
            && self.write_costs(values, budget, &mut changed);
        if self.changes.count() == 0 {
            self.cursors = Cursors::END;
        }
        let whole = CellRect {
            x0: 0,
            y0: 0,
            x1: self.width,
            y1: self.height,
        };
        if core::mem::take(&mut self.moved) {
            Some(whole)
        } else {
            changed.rect()
        }
    }
}
