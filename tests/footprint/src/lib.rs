//! What the programs of this package stand on: a start, and a panic handler that cannot be linked.
#![no_std]

pub mod robot;

use core::panic::PanicInfo;

use cortex_m_rt as _; // the vector table and the reset handler, which calls `main`

unsafe extern "C" {
    /// Defined nowhere: the linker names it when a panic can be reached.
    fn this_program_can_panic() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    // SAFETY: never linked, so never called.
    unsafe { this_program_can_panic() }
}

/// A value about which the optimiser knows nothing.
#[inline(always)]
pub fn opaque<T>(value: T) -> T {
    core::hint::black_box(value)
}

/// Makes a value, and all that leads to it, needed.
#[inline(always)]
pub fn need<T>(value: T) {
    core::hint::black_box(value);
}

/// Declares the program's start: `start!(run)` where `fn run()`.
#[macro_export]
macro_rules! start {
    ($run:path) => {
        #[unsafe(no_mangle)]
        extern "C" fn main() -> ! {
            $run();
            loop {
                core::hint::spin_loop();
            }
        }
    };
}

/// A static of this type and value, all bits zero, borrowed mutably; to be used once per place.
#[macro_export]
macro_rules! in_bss {
    ($type:ty, $empty:expr) => {{
        static mut STORAGE: $type = $empty;
        // SAFETY: one thread, and `run` runs once.
        unsafe { &mut *(&raw mut STORAGE) }
    }};
}

/// Declares `fn run()`, in which a robot maps with a cost map of so many cells along either side,
/// with this field, these scratch words and these words for the cells that a scan has seen.
#[macro_export]
macro_rules! run_cost_map {
    ($robot:path, $side:literal, $field:ty, $scratch:literal, $seen:literal) => {
        fn run() {
            use horus_core::prelude::{CostMapBuffers, ScanBuffers};
            use $crate::{in_bss, need, opaque};

            const BITS: usize = horus_core::costmap::bit_words($side, $side);
            type Storage = CostMapBuffers<{ $side * $side }, BITS, $field, $scratch>;
            let storage = in_bss!(Storage, Storage::empty());
            let beams = in_bss!(ScanBuffers<360, $seen>, ScanBuffers::empty());
            let ranges = opaque(in_bss!([f32; 360], [0.0; 360]));
            need($robot(
                storage.split(),
                &mut beams.workspace(),
                ranges,
                opaque($side),
            ));
        }
    };
}

/// Declares `fn run()`, in which a rolling grid takes scans with this model and these words for the
/// cells that a scan has seen.
#[macro_export]
macro_rules! run_scans {
    ($model:expr, $seen:literal) => {
        fn run() {
            use horus_core::prelude::{Pose2D, ScanBuffers, StaticOccupancyGrid};
            use $crate::{in_bss, need, opaque, robot};

            let grid = in_bss!(StaticOccupancyGrid<{ 200 * 200 }>, StaticOccupancyGrid::empty());
            let beams = in_bss!(ScanBuffers<360, $seen>, ScanBuffers::empty());
            let ranges = opaque(in_bss!([f32; 360], [0.0; 360]));
            need(grid.reset(200, 200, 0.05, opaque(Pose2D::new(-5.0, -5.0, 0.1))));
            let mut workspace = beams.workspace();
            loop {
                let pose = opaque(Pose2D::new(0.4, 0.7, 0.0));
                need(grid.recenter(pose));
                need(grid.integrate_scan(&robot::scan(ranges), pose, $model, &mut workspace));
                need((grid.world_to_grid(opaque(1.0), 2.0), grid.occupancy(opaque(1), 2)));
            }
        }
    };
}
