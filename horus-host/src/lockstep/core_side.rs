use horus_core::costmap::{CostTables, FieldCell};
use horus_core::prelude::{
    CostBuffers, CostMap, Error, LaserScan, LocalGridMap, OccupancyGrid, Pose2D, ScanModel, ScanReport,
    ScanWorkspace,
};

use super::local::{CoreLocal, LocalInput};
use super::storage::FieldStorage;
use super::{CoreStorage, Layers, LockstepConfig, LockstepError};
use crate::reference::LocalUpdate;

/// The embedded core's map, whatever the type of its field.
pub(super) struct CoreSide<'a> {
    map: Box<dyn CoreMap + 'a>,
    workspace: ScanWorkspace<'a>,
    model: ScanModel,
    local: Option<CoreLocal<'a>>,
}

impl<'a> CoreSide<'a> {
    /// A map whose corner lies at `origin`.
    pub fn new(
        config: &LockstepConfig,
        origin: Pose2D,
        storage: &'a mut CoreStorage,
    ) -> Result<Self, LockstepError> {
        let LockstepConfig { width, height, .. } = *config;
        let grid = OccupancyGrid::new_in(&mut storage.cells[..], width, height, config.resolution, origin)?;
        let rest = Buffers {
            bits: &mut storage.bits,
            scratch: &mut storage.scratch,
            costs: storage.costs.as_deref_mut(),
        };
        let map = match &mut storage.field {
            FieldStorage::One(field, tables) => rest.map(grid, field, tables, config)?,
            FieldStorage::Two(field, tables) => rest.map(grid, field, tables, config)?,
        };
        let beams = storage.beams.len();
        let local = match (config.local_config(), &mut storage.local) {
            (Some(config), Some(local)) => {
                let buffers = (&mut local.slots[..], &mut local.floats[..]);
                Some(CoreLocal::new(config, &mut local.cells, buffers, beams)?)
            }
            _ => None,
        };
        Ok(Self {
            map,
            local,
            workspace: ScanWorkspace::new_in(&mut storage.beams, &mut storage.seen),
            model: config.model,
        })
    }

    pub fn recenter(&mut self, robot: Pose2D) -> Result<[i32; 2], Error> {
        self.map.recenter(robot)
    }

    pub fn integrate(&mut self, scan: &LaserScan<'_>, sensor: Pose2D) -> Result<ScanReport, Error> {
        self.map.integrate(scan, sensor, self.model, &mut self.workspace)
    }

    /// An update of the local map, which the cost map follows.
    pub fn update_local(&mut self, input: &LocalInput) -> Result<LocalUpdate, Error> {
        let Some(local) = &mut self.local else {
            return Ok(LocalUpdate::default());
        };
        let update = local.update(input, &mut self.workspace)?;
        self.map.follow(local.map())?;
        Ok(update)
    }

    pub fn update_costs(&mut self) {
        self.map.update_costs();
    }

    /// Copies the map out.
    pub fn read(&self, layers: &mut Layers) {
        self.map.read(layers);
    }

    pub fn load(&mut self, cells: &[i8]) -> Result<(), Error> {
        self.map.load(cells)
    }

    pub fn occupancy(&self) -> &[i8] {
        self.map.occupancy()
    }

    pub fn read_row(&self, gy: u32, costs: &mut [u8]) {
        self.map.read_row(gy, costs);
    }
}

/// What a cost map borrows whatever the type of its field.
struct Buffers<'a> {
    bits: &'a mut [u32],
    scratch: &'a mut [u32],
    costs: Option<&'a mut [u8]>,
}

impl<'a> Buffers<'a> {
    fn map<F: FieldCell>(
        self,
        grid: OccupancyGrid<&'a mut [i8]>,
        field: &'a mut [F],
        tables: &'a mut CostTables<F>,
        config: &LockstepConfig,
    ) -> Result<Box<dyn CoreMap + 'a>, Error> {
        let Self { bits, scratch, costs } = self;
        let buffers = CostBuffers {
            bits,
            field,
            scratch,
            costs,
            tables,
        };
        Ok(Box::new(CostMap::new_in(grid, buffers, config.params)?))
    }
}

/// A core cost map with the type of its field erased.
trait CoreMap {
    fn recenter(&mut self, robot: Pose2D) -> Result<[i32; 2], Error>;
    fn integrate(
        &mut self,
        scan: &LaserScan<'_>,
        sensor: Pose2D,
        model: ScanModel,
        workspace: &mut ScanWorkspace<'_>,
    ) -> Result<ScanReport, Error>;
    fn follow(&mut self, local: &LocalGridMap<'_, &mut [u8]>) -> Result<(), Error>;
    fn update_costs(&mut self);
    fn read(&self, layers: &mut Layers);
    fn load(&mut self, cells: &[i8]) -> Result<(), Error>;
    fn occupancy(&self) -> &[i8];
    fn read_row(&self, gy: u32, costs: &mut [u8]);
}

impl<F: FieldCell> CoreMap for CostMap<'_, F> {
    fn recenter(&mut self, robot: Pose2D) -> Result<[i32; 2], Error> {
        CostMap::recenter(self, robot)
    }

    fn integrate(
        &mut self,
        scan: &LaserScan<'_>,
        sensor: Pose2D,
        model: ScanModel,
        workspace: &mut ScanWorkspace<'_>,
    ) -> Result<ScanReport, Error> {
        self.integrate_scan(scan, sensor, model, workspace)
    }

    fn follow(&mut self, local: &LocalGridMap<'_, &mut [u8]>) -> Result<(), Error> {
        local.update_cost_map(self)
    }

    fn update_costs(&mut self) {
        CostMap::update_costs(self);
    }

    fn read(&self, layers: &mut Layers) {
        layers.offset = self.info().offset();
        layers.occupancy.clear();
        layers.occupancy.extend_from_slice(self.occupancy_grid().data());
        layers.costs.clear();
        match self.costs() {
            Some(costs) => layers.costs.extend_from_slice(costs),
            None => (0..self.info().height()).for_each(|gy| layers.costs.extend(self.row(gy))),
        }
    }

    fn load(&mut self, cells: &[i8]) -> Result<(), Error> {
        CostMap::load(self, cells)
    }

    fn occupancy(&self) -> &[i8] {
        self.occupancy_grid().data()
    }

    fn read_row(&self, gy: u32, costs: &mut [u8]) {
        for (cost, value) in costs.iter_mut().zip(self.row(gy)) {
            *cost = value;
        }
    }
}
