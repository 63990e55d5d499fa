//! Prints the hashes of every scripted drive: the same lines on the host and on the target.
#![cfg_attr(target_os = "none", no_std, no_main)]

use horus_core::costmap::{CostBuffers, FieldCell};
use horus_core::local::BufferSlot;
use horus_core::prelude::{ScanBuffers, SensingState};
use horus_tests::drive::{self, FarBuffers, LidarBuffers, NearBuffers};
use horus_tests::report::{self, print};
use horus_tests::{Once, c_distance, c_drive, c_local};

horus_tests::start!(run);

fn run() -> bool {
    report::ended(all())
}

fn all() -> Result<(), horus_core::Error> {
    // One after the other in the same RAM; `static`, so that nothing large lies on the stack.
    static NEAR: Once<NearBuffers> = Once::new(NearBuffers::empty());
    static FAR: Once<FarBuffers> = Once::new(FarBuffers::empty());
    static LIDAR: Once<LidarBuffers> = Once::new(LidarBuffers::empty());
    // SAFETY: here only.
    let (near, far, lidar) = unsafe { (NEAR.take(), FAR.take(), LIDAR.take()) };
    let mut workspace = lidar.workspace();
    for scenario in drive::near_scenarios() {
        report::run(&scenario, drive::NEAR, near.split(), &mut workspace, print)?;
    }
    for scenario in drive::far_scenarios() {
        report::run(&scenario, drive::FAR, far.split(), &mut workspace, print)?;
    }
    // The drives that the C programs repeat.
    static COSTS: Once<c_drive::Costs> = Once::new([0; size_of::<c_drive::Costs>()]);
    // SAFETY: here only.
    let costs = unsafe { COSTS.take() };
    c_drive::run(&c_drive::direct(), near.split(), &mut workspace, print)?;
    c_drive::run(
        &c_drive::budgeted(),
        keep(near.split(), costs),
        &mut workspace,
        print,
    )?;
    c_drive::run(&c_drive::far(), keep(far.split(), costs), &mut workspace, print)?;
    static DISTANCES: Once<c_distance::Storage> = Once::new(c_distance::Storage::empty());
    // SAFETY: here only.
    c_distance::run(unsafe { DISTANCES.take() }, print)?;
    static SLOTS: Once<[BufferSlot; c_local::SLOTS]> = Once::new([BufferSlot::EMPTY; c_local::SLOTS]);
    static FLOATS: Once<[f32; c_local::FLOATS]> = Once::new([0.0; c_local::FLOATS]);
    static REAR: Once<ScanBuffers<{ c_local::BEAMS }, 0>> = Once::new(ScanBuffers::empty());
    // SAFETY: here only.
    let (slots, floats, rear) = unsafe { (SLOTS.take(), FLOATS.take(), REAR.take()) };
    let mut workspaces = [workspace, rear.workspace()];
    // Bytes that the other drives no longer need.
    let bytes = near.split().1.field;
    for scenario in &c_local::SCENARIOS {
        let state = SensingState::new_in(slots, floats, bytes);
        c_local::run(scenario, costs, state, &mut workspaces, print)?;
    }
    Ok(())
}

/// The same buffers, for a map that keeps its costs.
fn keep<'a, F: FieldCell>(
    (cells, buffers): (&'a mut [i8], CostBuffers<'a, F>),
    costs: &'a mut [u8],
) -> (&'a mut [i8], CostBuffers<'a, F>) {
    let costs = Some(costs);
    (cells, CostBuffers { costs, ..buffers })
}
