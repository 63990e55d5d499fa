//! Prints the hashes of every scripted drive: the same lines on the host and on the target.
#![cfg_attr(target_os = "none", no_std, no_main)]

use horus_tests::Once;
use horus_tests::drive::{self, FarBuffers, LidarBuffers, Line, NearBuffers};
use horus_tests::rt::hprintln;

horus_tests::start!(run);

fn print(line: Line) {
    hprintln!(
        "{} | tick {} | {} | {:08x}",
        line.scenario,
        line.tick,
        line.stage,
        line.hash.0
    );
}

fn run() -> bool {
    match all() {
        Ok(()) => true,
        Err(error) => {
            hprintln!("digest: {}", error);
            false
        }
    }
}

fn all() -> Result<(), horus_core::Error> {
    // One after the other in the same RAM; `static`, so that nothing large lies on the stack.
    static NEAR: Once<NearBuffers> = Once::new(NearBuffers::empty());
    static FAR: Once<FarBuffers> = Once::new(FarBuffers::empty());
    static LIDAR: Once<LidarBuffers> = Once::new(LidarBuffers::empty());
    // SAFETY: this function runs once.
    let (near, far, lidar) = unsafe { (NEAR.take(), FAR.take(), LIDAR.take()) };
    let mut workspace = lidar.workspace();
    for scenario in drive::near_scenarios() {
        drive::run(&scenario, drive::NEAR, near.split(), &mut workspace, print)?;
    }
    for scenario in drive::far_scenarios() {
        drive::run(&scenario, drive::FAR, far.split(), &mut workspace, print)?;
    }
    Ok(())
}
