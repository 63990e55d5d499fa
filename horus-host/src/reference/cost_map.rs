use super::inflation::{base_cost, inflate};
use super::{CostParams, Decay, OccupancyGrid, ReferenceError};

/// An occupancy grid and the cost of driving through each of its cells.
///
/// Changing the grid or a parameter takes effect at the next [`compute_costs`](Self::compute_costs). Parameters
/// written into the fields are not checked as [`with_params`](Self::with_params) checks them: illegal ones give
/// meaningless costs, nothing worse.
#[derive(Debug, Clone, PartialEq)]
pub struct CostMap {
    /// The occupancy the costs are computed from.
    pub occupancy_grid: OccupancyGrid,
    /// One cost per cell in the order of the grid's `data`: 0 free to `lethal_cost`, 255 unknown.
    pub costs: Vec<u8>,
    /// See [`CostParams::inflation_radius`].
    pub inflation_radius: f32,
    /// See [`CostParams::cost_scaling_factor`].
    pub cost_scaling_factor: f32,
    /// See [`CostParams::lethal_cost`].
    pub lethal_cost: u8,
    /// See [`CostParams::lethal_threshold`].
    pub lethal_threshold: i8,
    /// See [`CostParams::unknown_inflates`].
    pub unknown_inflates: bool,
    /// See [`CostParams::decay`].
    pub decay: Decay,
    /// See [`CostParams::inscribed_radius`].
    pub inscribed_radius: f32,
    /// See [`CostParams::inflate_unknown`].
    pub inflate_unknown: bool,
}

impl CostMap {
    /// The cost map of a grid with an inflation radius in metres and otherwise default parameters, computed.
    ///
    /// # Panics
    /// A radius that is negative or not finite; [`with_params`](Self::with_params) returns an error instead.
    pub fn from_occupancy_grid(grid: OccupancyGrid, inflation_radius: f32) -> Self {
        let params = CostParams {
            inflation_radius,
            ..CostParams::default()
        };
        match Self::with_params(grid, params) {
            Ok(map) => map,
            Err(error) => panic!("{error}"),
        }
    }

    /// The cost map of a grid, computed.
    ///
    /// # Errors
    /// A parameter outside its range.
    pub fn with_params(grid: OccupancyGrid, params: CostParams) -> Result<Self, ReferenceError> {
        params.validate()?;
        let mut map = Self {
            occupancy_grid: grid,
            costs: Vec::new(),
            inflation_radius: params.inflation_radius,
            cost_scaling_factor: params.cost_scaling_factor,
            lethal_cost: params.lethal_cost,
            lethal_threshold: params.lethal_threshold,
            unknown_inflates: params.unknown_inflates,
            decay: params.decay,
            inscribed_radius: params.inscribed_radius,
            inflate_unknown: params.inflate_unknown,
        };
        map.compute_costs();
        Ok(map)
    }

    /// Recomputes every cost from the occupancy.
    ///
    /// # Complexity
    /// One evaluation of the decay for every cell within reach of every obstacle.
    pub fn compute_costs(&mut self) {
        let (grid, params) = (&self.occupancy_grid, self.params());
        let base: Vec<u8> = grid.data.iter().map(|&v| base_cost(v, &params)).collect();
        self.costs = inflate(&base, grid.width as usize, grid.resolution, &params);
    }

    /// The cost at a world point in metres, 255 if unknown; `None` outside the map and for NaN or infinite points.
    pub fn cost(&self, x: f64, y: f64) -> Option<u8> {
        let (gx, gy) = self.occupancy_grid.world_to_grid(x, y)?;
        self.cost_of_cell(gx, gy)
    }

    /// The parameters of the next [`compute_costs`](Self::compute_costs).
    pub fn params(&self) -> CostParams {
        CostParams {
            inflation_radius: self.inflation_radius,
            cost_scaling_factor: self.cost_scaling_factor,
            lethal_cost: self.lethal_cost,
            lethal_threshold: self.lethal_threshold,
            unknown_inflates: self.unknown_inflates,
            decay: self.decay,
            inscribed_radius: self.inscribed_radius,
            inflate_unknown: self.inflate_unknown,
        }
    }

    pub(super) fn cost_of_cell(&self, gx: u32, gy: u32) -> Option<u8> {
        let index = self.occupancy_grid.index(gx, gy)?;
        self.costs.get(index).copied()
    }
}

impl Default for CostMap {
    /// A map without cells, with default parameters.
    fn default() -> Self {
        Self::from_occupancy_grid(OccupancyGrid::default(), CostParams::default().inflation_radius)
    }
}
