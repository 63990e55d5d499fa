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
use super::update::Work;
use crate::error::{Buffer, Error};
use crate::geometry::{Bounds, CellRect};
use crate::storage::{self, Bitmap, bitmap_words, words_per_row};

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

impl Cursors {
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
        let need = |buffer, needed, given| {
            if given < needed {
                Err(Error::BufferTooSmall {
                    buffer,
                    needed,
                    given,
                })
            } else {
                Ok(())
            }
        };
        let words = bitmap_words(width, height);
        need(Buffer::Bits, super::bit_words(width, height), bits.len())?;
        need(Buffer::Field, cells, field.len())?;
        if let Some(costs) = &costs {
            need(Buffer::Costs, cells, costs.len())?;
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
        let (needed, given) = (scratch_words(disc.radius), self.scratch.len());
        if given < needed {
            return Err(Error::BufferTooSmall {
                buffer: Buffer::Scratch,
                needed,
                given,
            });
        }
        self.tables.fill(&params, self.resolution, disc);
        self.params = params;
        Ok(())
    }

    pub(crate) fn steps(&self) -> Steps {
        Steps::new(self.tables.disc)
    }

    /// A cell of the grid has a new value.
    #[inline]
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
                *cost = self.tables.cost(value.byte(), *field);
            }
        }
    }

    /// Makes the source bits those of the cells' values.
    pub(super) fn read_sources<V: CellValue>(&mut self, values: &[V]) {
        let per_row = words_per_row(self.width);
        if per_row == 0 {
            return;
        }
        let rows = self.sources.chunks_exact_mut(per_row);
        for (words, values) in rows.zip(values.chunks_exact(self.width as usize)) {
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
        let mut refresh = Refresh {
            values,
            tables: self.tables,
            costs: self.costs.as_deref_mut(),
            changes: &self.changes,
            changed,
            width: self.width,
        };
        let repair = Repair {
            sources: Bitmap::new(self.sources, self.width, self.height),
            field: self.field,
            rect,
            scope,
            refresh: &mut refresh,
        };
        with_kernel(&self.tables.disc, self.scratch, repair);
    }

    /// The cost of a cell from its present value and the field.
    #[inline]
    pub(crate) fn cost(&self, i: usize, value: u8) -> Option<u8> {
        self.field.get(i).map(|field| self.tables.cost(value, *field))
    }

    /// The window moved by whole cells; the cells themselves have already moved.
    pub(crate) fn shift(&mut self, shift: [i32; 2], unknown: u8) {
        let [dx, dy] = shift;
        if dx == 0 && dy == 0 {
            return;
        }
        self.moved = true;
        let unknown_is_source = self.tables.is_source(unknown);
        let new_cost = if unknown_is_source {
            self.tables.cost(unknown, F::ZERO)
        } else {
            super::UNKNOWN_COST
        };
        if let Some(costs) = &mut self.costs {
            storage::shift_cells(costs, self.width, self.height, shift, new_cost);
        }
        if dx.unsigned_abs() >= self.width || dy.unsigned_abs() >= self.height {
            self.changes.clear();
            self.edges.clear();
            self.field.fill(if unknown_is_source { F::ZERO } else { F::NONE });
            self.sources.fill(0);
            if unknown_is_source {
                self.set_sources(CellRect {
                    x0: 0,
                    y0: 0,
                    x1: self.width,
                    y1: self.height,
                });
            }
            return;
        }
        storage::shift_bits(self.sources, self.width, self.height, shift);
        self.changes.shift(shift);
        self.cursors = Cursors::default();
        // New cells start at distance 0: never too cheap before they have been recomputed.
        storage::shift_cells(self.field, self.width, self.height, shift, F::ZERO);
        self.edges.shift(shift, self.tables.disc.radius);
        if unknown_is_source {
            self.expose_sources(shift);
        }
    }

    fn set_sources(&mut self, rect: CellRect) {
        let per_row = words_per_row(self.width);
        for gy in rect.y0..rect.y1 {
            for gx in rect.x0..rect.x1 {
                let w = gy as usize * per_row + gx as usize / 32;
                if let Some(word) = self.sources.get_mut(w) {
                    *word |= 1 << (gx % 32);
                }
            }
        }
    }

    /// Cells that came into view are sources: they lower the field along a straight line each.
    fn expose_sources(&mut self, [dx, dy]: [i32; 2]) {
        let (w, h) = (self.width, self.height);
        let (ax, ay) = (dx.unsigned_abs(), dy.unsigned_abs());
        let columns = if dx > 0 { w - ax..w } else { 0..ax };
        let rows = if dy > 0 { h - ay..h } else { 0..ay };
        self.set_sources(CellRect {
            x0: columns.start,
            y0: 0,
            x1: columns.end,
            y1: h,
        });
        self.set_sources(CellRect {
            x0: 0,
            y0: rows.start,
            x1: w,
            y1: rows.end,
        });
        for away in 1..=self.tables.disc.radius {
            let beside = if dx > 0 {
                columns.start.checked_sub(away)
            } else {
                Some(columns.end + away - 1)
            };
            if let Some(gx) = beside.filter(|gx| ax > 0 && *gx < w) {
                (0..h).for_each(|gy| self.lower(gx, gy, away));
            }
            let beside = if dy > 0 {
                rows.start.checked_sub(away)
            } else {
                Some(rows.end + away - 1)
            };
            if let Some(gy) = beside.filter(|gy| ay > 0 && *gy < h) {
                (0..w).for_each(|gx| self.lower(gx, gy, away));
            }
        }
    }

    /// A source lies `away` cells from this one, along an axis.
    fn lower(&mut self, gx: u32, gy: u32, away: u32) {
        let i = gy as usize * self.width as usize + gx as usize;
        let new = F::new(away * away);
        if let Some(field) = self.field.get_mut(i)
            && new < *field
        {
            *field = new;
            if self.costs.is_some() {
                self.mark(gx, gy); // its kept cost follows with the next update
            }
        }
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
        let search = self.sources.len().div_ceil(32) as u32 / self.steps().largest() + 1;
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
