//! A rolling cost map in the main loop of a robot: the README's program as a firmware image.
//!
//! On the host: `cargo run -p horus-core --example firmware`. For a Cortex-M4F:
//! `cargo build --release --target thumbv7em-none-eabihf -p horus-tests --bin firmware`.
#![cfg_attr(target_os = "none", no_std, no_main)]

use horus_core::costmap::bit_words;
use horus_core::prelude::*;

/// The lidar's beams.
const BEAMS: usize = 360;
/// Grid, cost map and all they need for 10 m x 10 m at 5 cm.
type Storage = CostMapBuffers<{ 200 * 200 }, { bit_words(200, 200) }>;

/// Drives for some ticks; the highest cost 30 cm ahead.
fn drive(storage: &mut Storage, beams: &mut ScanBuffers<BEAMS, 0>, ticks: u32) -> Result<Option<u8>, Error> {
    let (cells, buffers) = storage.split();
    let grid = OccupancyGrid::new_in(cells, 200, 200, 0.05, Pose2D::new(-5.0, -5.0, 0.0))?;
    let mut map = CostMap::new_in(grid, buffers, CostParams::nav2())?;
    let mut lidar = beams.workspace();
    let mut highest = None;
    for tick in 0..ticks {
        let (robot, ranges) = (odometry(tick), lidar_revolution(tick));
        let scan = LaserScan {
            angle_min: 0.0,
            angle_increment: core::f32::consts::TAU / BEAMS as f32,
            range_min: 0.1,
            range_max: 8.0,
            ranges: &ranges,
        };
        map.recenter(robot)?; // by whole cells
        map.integrate_scan(&scan, robot, ScanModel::Set, &mut lidar)?;
        map.update_costs_within(map.min_budget().max(20_000))?; // bounded work per tick
        highest = highest.max(map.cost(robot.x + 0.3, robot.y));
    }
    Ok(highest)
}

/// Stands for the wheels: straight ahead, 2 cm per tick.
fn odometry(tick: u32) -> Pose2D {
    Pose2D::new(0.02 * tick as f32, 0.0, 0.0)
}

/// Stands for the sensor: a wall 2 m ahead of the start, nothing elsewhere.
fn lidar_revolution(tick: u32) -> [f32; BEAMS] {
    let ahead = 2.0 - odometry(tick).x;
    let mut ranges = [f32::INFINITY; BEAMS];
    for range in ranges.iter_mut().take(10) {
        *range = ahead;
    }
    ranges
}

#[cfg(target_os = "none")]
mod image {
    use super::{BEAMS, ScanBuffers, Storage, drive};

    #[cortex_m_rt::entry]
    fn main() -> ! {
        // In .bss: no flash, no stack. Each can be taken once.
        let storage = cortex_m::singleton!(: Storage = Storage::empty());
        let beams = cortex_m::singleton!(: ScanBuffers<BEAMS, 0> = ScanBuffers::empty());
        if let (Some(storage), Some(beams)) = (storage, beams) {
            let _cost = core::hint::black_box(drive(storage, beams, u32::MAX));
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
    let mut storage = Box::new(Storage::empty());
    let mut beams = ScanBuffers::empty();
    let cost = drive(&mut storage, &mut beams, 90)?;
    println!("highest cost 30 cm ahead: {cost:?}");
    Ok(())
}
