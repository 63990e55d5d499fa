//! Everything a robot's mapping needs in one object, which lies in one `static`: two lidars, one
//! grid, one cost map that keeps its cost bytes for a planner.
//!
//! On the host: `cargo run -p horus-core --example static_buffers`. For a Cortex-M4F:
//! `cargo build --release --target thumbv7em-none-eabihf -p horus-tests --bin static_buffers`.
#![cfg_attr(target_os = "none", no_std, no_main)]

use horus_core::costmap::bit_words;
use horus_core::prelude::*;

/// Cells per side.
const SIDE: u32 = 150;
const CELLS: usize = (SIDE * SIDE) as usize;

/// All memory of the mapping; every bit is zero at first, so that it costs no flash image.
struct Mapping {
    map: CostMapBuffers<CELLS, { bit_words(SIDE, SIDE) }>,
    costs: [u8; CELLS],
    front: ScanBuffers<180, 0>,
    rear: ScanBuffers<90, 0>,
}

impl Mapping {
    const fn empty() -> Self {
        Self {
            map: CostMapBuffers::<CELLS, { bit_words(SIDE, SIDE) }>::empty(),
            costs: [0; CELLS],
            front: ScanBuffers::empty(),
            rear: ScanBuffers::empty(),
        }
    }

    /// One tick with both lidars; the number of cells at the lethal cost.
    fn tick(&mut self, robot: Pose2D, front: &[f32], rear: &[f32]) -> Result<usize, Error> {
        let (cells, mut buffers) = self.map.split();
        buffers.costs = Some(&mut self.costs);
        let grid = OccupancyGrid::new_in(cells, SIDE, SIDE, 0.05, Pose2D::new(-3.75, -3.75, 0.0))?;
        let mut map = CostMap::new_in(grid, buffers, CostParams::default())?;
        let looking = |by: f32| Pose2D::new(robot.x, robot.y, robot.theta + by);
        let scan = |ranges| LaserScan {
            angle_min: -core::f32::consts::FRAC_PI_2,
            angle_increment: 0.0174,
            range_min: 0.05,
            range_max: 6.0,
            ranges,
        };
        map.recenter(robot)?;
        // Each lidar keeps its own beams, so that their directions are computed once.
        let (mut ahead, mut behind) = (self.front.workspace(), self.rear.workspace());
        map.integrate_scan(&scan(front), looking(0.0), ScanModel::Set, &mut ahead)?;
        map.integrate_scan(
            &scan(rear),
            looking(core::f32::consts::PI),
            ScanModel::Set,
            &mut behind,
        )?;
        map.update_costs();
        let lethal = map.params().lethal_cost;
        Ok(map
            .costs()
            .map_or(0, |costs| costs.iter().filter(|c| **c == lethal).count()))
    }
}

#[cfg(target_os = "none")]
mod image {
    use super::{Mapping, Pose2D};

    #[cortex_m_rt::entry]
    fn main() -> ! {
        if let Some(mapping) = cortex_m::singleton!(: Mapping = Mapping::empty()) {
            let cells = mapping.tick(Pose2D::new(0.1, 0.0, 0.0), &[1.5; 180], &[f32::INFINITY; 90]);
            let _cells = core::hint::black_box(cells);
        }
        loop {
            cortex_m::asm::wfi();
        }
    }

    #[panic_handler]
    fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
        loop {
            cortex_m::asm::bkpt();
        }
    }
}

#[cfg(not(target_os = "none"))]
fn main() -> Result<(), Error> {
    let mut mapping = Box::new(Mapping::empty());
    let cells = mapping.tick(Pose2D::new(0.1, 0.0, 0.0), &[1.5; 180], &[f32::INFINITY; 90])?;
    println!("{cells} lethal cells");
    Ok(())
}
