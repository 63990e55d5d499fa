use horus_core::Error;
use horus_core::costmap::FieldCell;
use horus_core::prelude::*;
use horus_tests::workload::{Office, RESOLUTION};

/// One map and its parameters.
pub struct Case {
    /// Its name in the table.
    pub setting: &'static str,
    /// Cells per side.
    pub side: u32,
    /// Costs reach so many cells; checked.
    radius_cells: u32,
    /// Parameters.
    pub params: CostParams,
}

impl Case {
    /// Exponential decay from 0.1 m on; `scaling` low enough for costs to reach the radius.
    const fn new(setting: &'static str, side: u32, radius_cells: u32, scaling: f32) -> Self {
        let params = CostParams {
            inflation_radius: radius_cells as f32 * RESOLUTION,
            cost_scaling_factor: scaling,
            lethal_cost: 254,
            lethal_threshold: 100,
            unknown_inflates: false,
            decay: Decay::Exponential,
            inscribed_radius: 0.1,
            inflate_unknown: false,
        };
        Self {
            setting,
            side,
            radius_cells,
            params,
        }
    }

    /// A grid of this size, unknown, the corner of its first cell at an office cell.
    pub fn grid<'a>(
        &self,
        cells: &'a mut [i8],
        corner: (f32, f32),
    ) -> Result<OccupancyGrid<&'a mut [i8]>, Error> {
        let origin = Pose2D::new(corner.0 * RESOLUTION, corner.1 * RESOLUTION, 0.0);
        OccupancyGrid::new_in(cells, self.side, self.side, RESOLUTION, origin)
    }

    /// Makes a map show the office, free or occupied everywhere, all costs computed.
    pub fn show<F: FieldCell>(&self, office: &Office, map: &mut CostMap<'_, F>) {
        assert_eq!(map.effective_radius(), self.radius_cells, "{}", self.setting);
        for gy in 0..self.side {
            for gx in 0..self.side {
                let (x, y) = map.info().grid_to_world(gx, gy).unwrap_or_default();
                let cell = |metres: f32| libm::floorf(metres / RESOLUTION) as i32;
                let value = if office.is_blocked(cell(x), cell(y)) {
                    100
                } else {
                    0
                };
                map.set_occupancy(gx, gy, value);
            }
        }
        map.compute_costs();
    }
}

/// What the targets are for.
pub const R11: Case = Case::new("200x200 u8 R 11", 200, 11, 10.0);
/// The largest radius of a one-byte field.
pub const R15: Case = Case::new("200x200 u8 R 15", 200, 15, 3.0);
/// Costs kept as a slice, too.
pub const R11_KEPT: Case = Case::new("160x160 u8 R 11 kept", 160, 11, 10.0);
/// A two-byte field; 200 x 200 cells of it do not fit into 128 KiB.
pub const R20: Case = Case::new("160x160 u16 R 20", 160, 20, 2.0);
/// A radius beyond 31 cells, with the largest frame.
pub const R40: Case = Case::new("100x100 u16 R 40", 100, 40, 2.0);
