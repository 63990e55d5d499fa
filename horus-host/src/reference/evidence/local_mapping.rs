use super::resample::{seen_from, transform};
use super::{
    BinaryThresholds, Flatscan, FusionOperator, Inpaint, Lattice, Masses, SensorModel, evidence_to_binary,
    fuse, sample, scan_to_evidence,
};
use crate::reference::frame::GridFrame;

/// A sensor on the robot; see the core's `SensorConfig`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sensor {
    /// The cells its scans are turned into, in the robot's frame.
    pub lattice: Lattice,
    /// x, y (metres) and heading (radians) in the robot's frame.
    pub mount: [f32; 3],
    /// What its beams say.
    pub model: SensorModel,
}

/// What the stages do; see the core's type of that name.
#[derive(Debug, Clone, PartialEq)]
pub struct LocalMappingConfig {
    /// The window of the fused map in the world.
    pub lattice: Lattice,
    /// How scans are fused.
    pub operator: FusionOperator,
    /// Least uncertain mass under the two rules that lock in.
    pub ignorance_floor: f64,
    /// The sensors.
    pub sensors: Vec<Sensor>,
    /// Painted rectangles, the last one uppermost.
    pub inpaint: Vec<Inpaint>,
    /// What is occupied.
    pub thresholds: BinaryThresholds,
}

/// The chain of local mapping, cell by cell.
#[derive(Debug, Clone, PartialEq)]
pub struct LocalMapping {
    /// What it does.
    pub config: LocalMappingConfig,
    /// Cells the window has moved.
    pub offset: [i32; 2],
    /// The fused map, x fastest.
    pub cells: Vec<Masses>,
    /// Where the robot stood at the last tick.
    robot: [f32; 3],
}

impl LocalMapping {
    /// A map that knows nothing.
    pub fn new(config: LocalMappingConfig) -> Self {
        Self {
            offset: [0, 0],
            cells: vec![Masses::VACUOUS; config.lattice.len()],
            robot: [0.0; 3],
            config,
        }
    }

    /// Moves the window to the robot and fuses scans, each with the index of its sensor. Returns the cells the window
    /// moved; `None` if the pose is not finite or too far away, with nothing changed.
    pub fn tick(&mut self, scans: &[(usize, Flatscan)], robot: [f32; 3]) -> Option<[i32; 2]> {
        let shift = self.recenter(robot)?;
        for (sensor, scan) in scans {
            let sensor = self.config.sensors[*sensor];
            let seen = scan_to_evidence(scan, sensor.mount, &sensor.lattice, &sensor.model);
            self.fuse(&seen, &sensor.lattice, robot);
        }
        Some(shift)
    }

    fn frame(&self) -> GridFrame {
        let Lattice { pose, cell_size, .. } = self.config.lattice;
        GridFrame::new(pose, cell_size, self.offset)
    }

    fn recenter(&mut self, robot: [f32; 3]) -> Option<[i32; 2]> {
        if !robot.iter().all(|v| v.is_finite()) {
            return None;
        }
        let lattice = self.config.lattice;
        let size = [lattice.rows, lattice.cols];
        let (shift, offset) = self.frame().shift([robot[0], robot[1]], size)?;
        let from = |(gx, gy): (u32, u32)| {
            let index = lattice.index(
                i64::from(gx) + i64::from(shift[0]),
                i64::from(gy) + i64::from(shift[1]),
            );
            index.map_or(Masses::VACUOUS, |i| self.cells[i])
        };
        self.cells = lattice.cells().map(from).collect();
        self.offset = offset;
        self.robot = robot;
        Some(shift)
    }

    /// Fuses an evidence grid in the robot's frame into every cell.
    fn fuse(&mut self, seen: &[Masses], lattice: &Lattice, robot: [f32; 3]) {
        let window = self.config.lattice;
        let cell_size = f64::from(window.cell_size);
        for (i, (gx, gy)) in window.cells().enumerate() {
            let along = |g: u32, axis: usize| (f64::from(self.offset[axis]) + f64::from(g) + 0.5) * cell_size;
            let world = transform(window.pose.map(f64::from), [along(gx, 0), along(gy, 1)]);
            let here = sample(seen, lattice, seen_from(robot.map(f64::from), world));
            let fused = fuse(
                self.config.operator,
                self.config.ignorance_floor,
                self.cells[i],
                here,
            );
            self.cells[i] = fused.unwrap_or(Masses::VACUOUS);
        }
    }

    /// The fused map after painting.
    pub fn inpainted(&self) -> Vec<Masses> {
        let frame = self.frame();
        let paint = |((gx, gy), fused): ((u32, u32), &Masses)| {
            let mut painted = *fused;
            for inpaint in &self.config.inpaint {
                if inpaint.holds(frame.center(gx, gy), self.robot) {
                    painted = inpaint.masses;
                }
            }
            painted
        };
        self.config.lattice.cells().zip(&self.cells).map(paint).collect()
    }

    /// Whether each cell is occupied, after painting.
    pub fn binary(&self) -> Vec<bool> {
        evidence_to_binary(&self.inpainted(), &self.config.thresholds)
    }
}
