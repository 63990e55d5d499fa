//! The building.

use super::circuit::Circuit;
use super::floor_plan::{FloorPlan, ROOMS, SIZE};
use super::furniture::Furniture;
use super::random::{Random, Use};
use super::{Disc, OrientedBox, Segment};

/// Spacing of the points that stand for the robot's way while furniture is placed, in metres.
const WAY_STEP: f64 = 0.05;

/// Everything in a building that does not move.
///
/// World frame, metres; the outer walls' centre lines run from (0, 0) to (20, 20).
#[derive(Debug, Clone)]
pub struct World {
    boxes: Vec<OrientedBox>,
    discs: Vec<Disc>,
    edges: Vec<Segment>,
    plan: FloorPlan,
    circuit: Circuit,
}

impl World {
    /// A building of 16 rooms of 4 to 6 m, each with at least two doors of 0.95 to 1.1 m, some
    /// windows, and furniture. The same seed gives the same building.
    pub fn building(seed: u64) -> Self {
        let mut random = Random::new(seed, Use::Building);
        let plan = FloorPlan::new(&mut random);
        let circuit = Circuit::new(&plan);
        let steps = (circuit.length() / WAY_STEP) as usize;
        let way: Vec<_> = (0..=steps)
            .map(|i| circuit.pose(i as f64 * WAY_STEP))
            .map(|pose| (pose.x, pose.y))
            .collect();
        let furniture = Furniture::new(&plan, &way, &mut random);
        let mut boxes: Vec<_> = plan.walls.iter().flat_map(|wall| wall.boxes()).collect();
        boxes.extend(furniture.boxes);
        Self {
            edges: boxes.iter().flat_map(OrientedBox::edges).collect(),
            boxes,
            discs: furniture.discs,
            plan,
            circuit,
        }
    }

    /// Pieces of wall, cabinets and crates. Windows are gaps between pieces of wall.
    pub fn boxes(&self) -> &[OrientedBox] {
        &self.boxes
    }

    /// Plants and the legs of tables.
    pub fn discs(&self) -> &[Disc] {
        &self.discs
    }

    /// The edges of all boxes, each with its box on the left.
    pub fn edges(&self) -> &[Segment] {
        &self.edges
    }

    /// Lower left and upper right corner of the building in metres, without the outer half of its
    /// outer walls (0.06 m).
    pub fn bounds(&self) -> [(f64, f64); 2] {
        [(0.0, 0.0), (SIZE, SIZE)]
    }

    /// The distance from a point to the nearest obstacle; 0 within one.
    pub fn clearance(&self, x: f64, y: f64) -> f64 {
        let boxes = self.boxes.iter().map(|solid| solid.distance((x, y)));
        let discs = self.discs.iter().map(|disc| disc.distance((x, y)));
        boxes.chain(discs).fold(f64::INFINITY, f64::min)
    }

    /// The number of the room that holds a point, 0..16; `None` outside the building.
    pub fn room_at(&self, x: f64, y: f64) -> Option<usize> {
        let (column, row) = self.plan.room_at((x, y))?;
        Some(row * ROOMS + column)
    }

    pub(super) fn plan(&self) -> &FloorPlan {
        &self.plan
    }

    pub(super) fn circuit(&self) -> &Circuit {
        &self.circuit
    }
}
