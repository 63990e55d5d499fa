use super::budget::Budget;
use super::buffers::CostBuffers;
use super::field::FieldCell;
use super::footprint::{self, FootprintCost};
use super::layer::Layer;
use super::{CellValue, CostParams};
use crate::error::Error;
use crate::geometry::{Bounds, CellRect, GridInfo, Pose2D};
use crate::grid::{ChangeSink, LaserScan, OccupancyGrid, ScanModel, ScanReport, ScanWorkspace, UNKNOWN};

/// An occupancy grid with inflated costs that follow its every change.
///
/// `F` is the distance field's cell: `u8` (the default) for costs that reach up to 15 cells, `u16`
/// for up to 255. Costs are bytes: 0 free .. `lethal_cost`, 255 unknown.
///
/// All changes go through the map: [`set_occupancy`](Self::set_occupancy),
/// [`integrate_scan`](Self::integrate_scan), [`recenter`](Self::recenter), [`load`](Self::load).
/// Then [`update_costs`](Self::update_costs) brings the costs up to date. Between a change and the
/// finished update [`cost`](Self::cost) shows the present base cost with the old inflation; kept
/// bytes ([`costs`](Self::costs)) show the last update.
///
/// RAM, occupancy included: 2.25 bytes per cell (`u8`) or 3.25 (`u16`), one more with kept bytes,
/// plus O(width + height) and at most 4 KiB (`u8`) or 10 KiB (`u16`).
///
/// Source: HORUS `CostMap`; nav2's inflation layer for [`Decay::Exponential`](super::Decay).
///
/// # Examples
/// ```
/// use horus_core::prelude::*;
/// use horus_core::costmap::bit_words;
///
/// let mut buffers = CostMapBuffers::<{ 40 * 40 }, { bit_words(40, 40) }>::empty();
/// let (cells, cost_buffers) = buffers.split();
/// let grid = OccupancyGrid::new_in(cells, 40, 40, 0.05, Pose2D::new(-1.0, -1.0, 0.0))?;
/// let mut map = CostMap::new_in(grid, cost_buffers, CostParams::default())?;
///
/// map.set_occupancy(20, 20, 100);
/// map.set_occupancy(21, 20, 0);
/// let changed = map.update_costs();
/// assert_eq!(map.cost_at(20, 20), Some(253));
/// assert_eq!(map.cost_at(21, 20), Some(97));
/// assert_eq!(map.cost(9.0, 0.0), None, "outside");
/// # assert!(changed.is_some());
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug)]
pub struct CostMap<'a, F: FieldCell = u8> {
    grid: OccupancyGrid<&'a mut [i8]>,
    layer: Layer<'a, F>,
}

/// What a budgeted update did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CostUpdate {
    /// Every cost that differs from before the call lies in here, in the map's present indices.
    pub changed: Option<CellRect>,
    /// Changed cells and edge blocks that still wait; 0: every cost is exact.
    pub pending: u32,
}

impl<'a, F: FieldCell> CostMap<'a, F> {
    /// A cost map over a grid, computed in full.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`]; [`Error::RadiusTooLarge`] if costs above zero reach farther
    /// than `F` holds; [`Error::BufferTooSmall`].
    ///
    /// # Complexity
    /// As [`compute_costs`](Self::compute_costs).
    pub fn new_in(
        grid: OccupancyGrid<&'a mut [i8]>,
        buffers: CostBuffers<'a, F>,
        params: CostParams,
    ) -> Result<Self, Error> {
        let mut layer = Layer::new(grid.width(), grid.height(), grid.resolution(), buffers, params)?;
        layer.compute(grid.data());
        Ok(Self { grid, layer })
    }

    /// The grid as it is now.
    pub fn occupancy_grid(&self) -> &OccupancyGrid<&'a mut [i8]> {
        &self.grid
    }

    /// Size, resolution and place of the map.
    pub fn info(&self) -> &GridInfo {
        self.grid.info()
    }

    /// The grid's frame name, text and time stamp.
    pub fn set_header(&mut self, frame_id: &str, timestamp_ns: u64) {
        self.grid.set_frame_id(frame_id);
        self.grid.timestamp_ns = timestamp_ns;
    }

    /// The parameters in force.
    pub fn params(&self) -> &CostParams {
        &self.layer.params
    }

    /// Largest offset, in cells, at which a source still costs something.
    pub fn effective_radius(&self) -> u32 {
        self.layer.tables.disc.radius
    }

    /// Takes new parameters and recomputes everything before it returns.
    ///
    /// # Errors
    /// As [`new_in`](Self::new_in); nothing changes then.
    ///
    /// # Complexity
    /// As [`compute_costs`](Self::compute_costs), plus one evaluation of the cost per squared
    /// distance within reach.
    pub fn set_params(&mut self, params: CostParams) -> Result<(), Error> {
        self.layer.set_params(params)?;
        self.compute_costs();
        Ok(())
    }

    /// Computes every cost from the cells.
    ///
    /// # Complexity
    /// One read per cell value; per row of 32 cells, two scratch words per pair of offsets in a
    /// quarter of the disc, and one write per cell (two with kept bytes).
    pub fn compute_costs(&mut self) {
        self.layer.compute(self.grid.data());
    }

    /// Brings every cost up to date with all changes since the last update: equal to
    /// [`compute_costs`](Self::compute_costs) in every byte. Returns the rectangle that contains
    /// every cost that changed: the smallest with kept bytes; without them it may also hold cells
    /// written back to their old value; after a window shift the whole map. `None`: none changed.
    ///
    /// # Complexity
    /// Per source that appeared one disc of cells, per source that vanished the cells it was
    /// nearest to; per shift the strips within the radius of the edges. Never more than about
    /// twice a full recompute.
    pub fn update_costs(&mut self) -> Option<CellRect> {
        self.layer.update(self.grid.data(), &mut Budget::unlimited())
    }

    /// As [`update_costs`](Self::update_costs), but stops before it exceeds `budget` cell visits (a
    /// visit is one field or cost byte read or written, or one bitmap word), and goes on with the
    /// next call. Sources that appeared are applied before sources that vanished: once they are
    /// in, no known cell is cheaper than its final cost.
    ///
    /// # Errors
    /// [`Error::BudgetTooSmall`] below [`min_budget`](Self::min_budget); nothing is done then.
    ///
    /// # Complexity
    /// At most `budget` cell visits. Once changes stop, [`calls_left`](Self::calls_left) calls
    /// reach the exact result.
    pub fn update_costs_within(&mut self, budget: u32) -> Result<CostUpdate, Error> {
        let min = self.min_budget();
        if budget < min {
            return Err(Error::BudgetTooSmall { min, given: budget });
        }
        let changed = self.layer.update(self.grid.data(), &mut Budget::new(budget));
        Ok(CostUpdate {
            changed,
            pending: self.layer.pending(),
        })
    }

    /// The smallest budget, S(R): the largest single step of an update, in cell visits. For an
    /// effective radius of 1 <= R <= 15 cells and n = 2 R + 1 it is
    /// `3 + max(2 + 5 n^2, 2 + 6 n^2 + 32 n + 6 (n + 2 R), 5120 + 6 (32 + 2 R))`, a few more
    /// bitmap words beyond.
    pub fn min_budget(&self) -> u32 {
        self.layer.steps().largest()
    }

    /// Changed cells and edge blocks that wait for an update; 0: every cost is exact.
    pub fn pending(&self) -> u32 {
        self.layer.pending()
    }

    /// Upper bound on the calls of [`update_costs_within`](Self::update_costs_within), each with at
    /// least [`min_budget`](Self::min_budget), that make every cost exact if nothing else changes.
    pub fn calls_left(&self) -> u32 {
        self.layer.calls_left()
    }

    /// Sets a cell, clamped to -1..=100; outside the map: `false`.
    ///
    /// Complexity: constant; the costs follow with the next update.
    pub fn set_occupancy(&mut self, gx: u32, gy: u32, value: i8) -> bool {
        match self.grid.replace(gx, gy, value) {
            Some(changed) => {
                if changed {
                    self.layer.mark(gx, gy);
                }
                true
            }
            None => false,
        }
    }

    /// Integrates a laser scan as [`OccupancyGrid::integrate_scan`] does.
    ///
    /// # Errors
    /// As there.
    pub fn integrate_scan(
        &mut self,
        scan: &LaserScan<'_>,
        sensor_pose: Pose2D,
        model: ScanModel,
        workspace: &mut ScanWorkspace<'_>,
    ) -> Result<ScanReport, Error> {
        let mut sink = Marks {
            layer: &mut self.layer,
            changed: Bounds::EMPTY,
        };
        self.grid
            .integrate_scan_into(scan, sensor_pose, model, workspace, &mut sink)
    }

    /// Moves the window as [`OccupancyGrid::recenter`] does; costs move with their cells. Sources
    /// that leave count as removed; new cells are unknown at once.
    ///
    /// # Errors
    /// As there.
    ///
    /// # Complexity
    /// One read and one write per cell and layer; none for a zero shift.
    pub fn recenter(&mut self, pose: Pose2D) -> Result<[i32; 2], Error> {
        let shift = self.grid.recenter(pose)?;
        self.layer.shift(shift, UNKNOWN.byte());
        Ok(shift)
    }

    /// Moves the window as [`recenter`](Self::recenter) does, to an offset within 2^30 cells.
    pub(crate) fn move_to(&mut self, offset: [i32; 2]) {
        let shift = self.grid.move_to(offset);
        self.layer.shift(shift, UNKNOWN.byte());
    }

    /// Replaces all cells, row-major, each clamped to -1..=100, and recomputes everything.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`] unless there is one value per cell; nothing changes then.
    pub fn load(&mut self, values: &[i8]) -> Result<(), Error> {
        self.grid.load(values)?;
        self.compute_costs();
        Ok(())
    }

    /// The cost at a world point (metres); outside the map, NaN or infinite: `None`.
    pub fn cost(&self, x: f32, y: f32) -> Option<u8> {
        let (gx, gy) = self.grid.world_to_grid(x, y)?;
        self.cost_at(gx, gy)
    }

    /// The cost of a cell; outside the map: `None`.
    pub fn cost_at(&self, gx: u32, gy: u32) -> Option<u8> {
        let i = self.grid.info().index(gx, gy)?;
        self.layer.cost(i, self.grid.data().get(i)?.byte())
    }

    /// The costs of a row, in order of gx; empty outside the map.
    pub fn row(&self, gy: u32) -> impl ExactSizeIterator<Item = u8> + '_ {
        self.row_part(gy, 0, self.grid.width())
    }

    /// The costs of the cells `x0 <= gx < x1` of a row, cut to the map.
    pub(crate) fn row_part(&self, gy: u32, x0: u32, x1: u32) -> impl ExactSizeIterator<Item = u8> + '_ {
        let width = self.grid.width();
        let start = if gy < self.grid.height() {
            gy as usize * width as usize
        } else {
            usize::MAX
        };
        let part = start.saturating_add(x0 as usize)..start.saturating_add(x1.min(width) as usize);
        let values = self.grid.data().get(part.clone()).unwrap_or_default();
        let fields = self.layer.field.get(part).unwrap_or_default();
        let tables = &*self.layer.tables;
        values
            .iter()
            .zip(fields)
            .map(move |(value, field)| tables.cost(value.byte(), *field))
    }

    /// The kept cost bytes, row-major, as of the last update; `None` if none are kept.
    pub fn costs(&self) -> Option<&[u8]> {
        self.layer.costs.as_deref()
    }

    /// The highest known cost under a polygon (vertices (x, y) in metres, in the frame of `pose`, which
    /// lies in the world frame), and whether the polygon touches unknown cells or leaves the map.
    /// A cell lies under it if its centre is inside (even-odd rule) or an edge crosses it.
    ///
    /// # Errors
    /// [`Error::NonFinitePose`]; [`Error::InvalidPolygon`] with fewer than three vertices or one
    /// that is not finite or lies more than 2^30 cells away.
    ///
    /// # Complexity
    /// One look-up per cell under it; per row of its bounding box inside the map and 32 columns,
    /// one float operation sequence per vertex.
    pub fn footprint_cost<V: Copy + Into<(f32, f32)>>(
        &self,
        pose: Pose2D,
        polygon: &[V],
    ) -> Result<FootprintCost, Error> {
        footprint::cost(self.grid.info(), pose, polygon, |gx, gy| self.cost_at(gx, gy))
    }
}

/// Passes a scan's changes on to the layer.
struct Marks<'m, 'a, F: FieldCell> {
    layer: &'m mut Layer<'a, F>,
    changed: Bounds,
}

impl<F: FieldCell> ChangeSink for Marks<'_, '_, F> {
    fn changed(&mut self, gx: u32, gy: u32) {
        self.changed.add(gx, gy);
        self.layer.mark(gx, gy);
    }

    fn rect(&self) -> Option<CellRect> {
        self.changed.rect()
    }
}
